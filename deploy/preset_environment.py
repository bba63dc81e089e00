"""Prints what a test preset of CMakePresets.json has in its environment, for a shell to evaluate.

usage: eval "$(/usr/bin/python3 deploy/preset_environment.py PRESET)"
"""

import json
import pathlib
import shlex
import sys

root = pathlib.Path(__file__).resolve().parents[1]
for preset in json.loads((root / "CMakePresets.json").read_text())["testPresets"]:
    if preset["name"] == sys.argv[1]:
        for name, value in preset["environment"].items():
            print(f"export {name}={shlex.quote(value.replace('${sourceDir}', str(root)))}")
