"""No field of the server's answers is lost on the way to a robot's program."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import asdict
from typing import Any

import pytest
from google.protobuf.descriptor import Descriptor, FieldDescriptor
from google.protobuf.message import Message

from fovea.detections import detections_from_proto
from fovea.enums import name_of
from fovea.picks import pick_from_proto
from fovea.server_info import options_from_proto, server_info_from_proto, statistics_from_proto
from fovea.v1 import (
    detection_pb2,
    detection_service_pb2,
    frame_pb2,
    observation_service_pb2,
)

# Always the same by the contract: 16 bits, millimetres.
UNREAD = {"trace.filled_depth.encoding", "trace.filled_depth.unit_m"}

# Bytes of images of one pixel, and clouds of one point.
NUM_BYTES = {"LabelImage": 2, "DepthImage": 2, "SaliencyMap": 1, "HeightMap": 4, "PointCloud": 3}
LISTS = {"positions": [1] * 3, "pose_covariance": [1] * 16, "runs": [0, 1]}
# Room for a mask whose bounds begin at 1.
IMAGE_SIZE = ("fovea.v1.Detections.width", "fovea.v1.Detections.height")

Leaf = tuple[str, Callable[[], object]]  # its path, and what gives it another value


def value_of(field: FieldDescriptor, number: int) -> Any:
    if field.type == field.TYPE_BYTES:
        return bytes([number]) * NUM_BYTES[field.containing_type.name]
    if field.full_name in IMAGE_SIZE:
        return number + 1
    return str(number) if field.type == field.TYPE_STRING else number


def num_choices(kind: Descriptor) -> int:
    """Of what a message may be: grippers are of two kinds."""
    return max([len(each.fields) for each in kind.oneofs], default=1)


def is_chosen(field: FieldDescriptor, choice: int) -> bool:
    choices = field.containing_oneof.fields if field.containing_oneof else [field]
    return len(choices) == 1 or field is choices[choice]


def leaves(message: Message, path: str = "", choice: int = 0) -> Iterator[Leaf]:
    """Sets all that there is in a message, and says of each number and text how to change it."""
    for field in message.DESCRIPTOR.fields:
        if is_chosen(field, choice):
            yield from leaves_of(message, field, path + field.name)


def leaves_of(message: Message, field: FieldDescriptor, path: str) -> Iterator[Leaf]:
    held = getattr(message, field.name)
    if field.message_type and field.message_type.GetOptions().map_entry:
        value = field.message_type.fields_by_name["value"]
        if value.message_type:
            yield from leaves(held["1"], f"{path}[].")
        else:
            held["1"] = 1
            yield path, lambda: held.update({"1": 0})
    elif field.message_type and field.label == field.LABEL_REPEATED:
        for choice in range(num_choices(field.message_type)):
            yield from leaves(held.add(), f"{path}[{choice}].", choice)
    elif field.message_type:
        yield from leaves(held, f"{path}.")
    elif field.label == field.LABEL_REPEATED:
        held.extend(LISTS.get(field.name, [value_of(field, 1)]))
        yield path, lambda: held.__setitem__(-1, value_of(field, 0))
    else:
        setattr(message, field.name, value_of(field, 1))
        yield path, lambda: setattr(message, field.name, value_of(field, 0))


def said(message: Message, convert: Callable[[Any], Any]) -> str:
    try:
        made = convert(message)
    except ValueError as error:  # sizes that contradict each other
        return str(error)
    parts = made if isinstance(made, list) else [made]
    return repr([asdict(part) for part in parts])


@pytest.mark.parametrize(
    "kind, convert",
    [
        (detection_pb2.Detections, detections_from_proto),
        (detection_service_pb2.Pick, pick_from_proto),
        (detection_service_pb2.GetServerInfoResponse, server_info_from_proto),
        (detection_service_pb2.ListOptionsResponse, options_from_proto),
        (detection_service_pb2.GetStatisticsResponse, statistics_from_proto),
    ],
)
def test_every_field_reaches_the_program(
    kind: type[Message], convert: Callable[[Any], Any]
) -> None:
    whole = kind()
    num_leaves = len(list(leaves(whole)))
    before = said(whole, convert)
    assert before.startswith("[{"), before
    unread = set()
    for index in range(num_leaves):
        changed = kind()
        path, change = list(leaves(changed))[index]
        assert said(changed, convert) == before
        change()
        if said(changed, convert) == before:
            unread.add(path)
    assert unread == (UNREAD if kind is detection_pb2.Detections else set())


def test_numbers_of_each_enum_have_names() -> None:
    enums = [
        getattr(module, name)
        for module in (detection_pb2, frame_pb2, observation_service_pb2)
        for name in module.DESCRIPTOR.enum_types_by_name
    ]
    for enum in enums:
        prefix = re.sub("(?<=[a-z])(?=[A-Z])", "_", enum.DESCRIPTOR.name).upper()
        for name, number in enum.items():
            assert f"{prefix}_{name_of(enum, number).upper()}" == name
    assert name_of(detection_pb2.GraspKind, detection_pb2.GRASP_KIND_RIM) == "rim"
    assert name_of(detection_pb2.GraspKind, 99) == "99"
