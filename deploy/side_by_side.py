"""Puts pictures side by side into one, each under its name.

usage: side_by_side.py OUTPUT PICTURE...
"""

import sys
from pathlib import Path

from PIL import Image, ImageDraw

WIDTH, HEIGHT, TITLE = 640, 480, 20


def put_together(pictures: list[Path]) -> Image.Image:
    columns = min(2, len(pictures))
    rows = -(-len(pictures) // columns)
    sheet = Image.new("RGB", (columns * WIDTH, rows * (HEIGHT + TITLE)), "white")
    for index, path in enumerate(pictures):
        x, y = index % columns * WIDTH, index // columns * (HEIGHT + TITLE)
        ImageDraw.Draw(sheet).text((x + 6, y + 4), path.stem, fill="black")
        with Image.open(path) as picture:
            picture.thumbnail((WIDTH, HEIGHT))
            sheet.paste(picture, (x, y + TITLE))
    return sheet


if __name__ == "__main__":
    put_together([Path(path) for path in sys.argv[2:]]).save(sys.argv[1])
