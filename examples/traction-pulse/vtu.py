"""Reads the particle files of abut (.vtu, LZ4 blocks) without any package; for large files use VTK or ParaView."""

import array
import re
import struct
import sys


def _lz4(block, size):
    """One LZ4 block."""
    out = bytearray()
    i, n = 0, len(block)
    while i < n:
        token = block[i]
        i += 1
        length = token >> 4
        if length == 15:
            while True:
                more = block[i]
                i += 1
                length += more
                if more != 255:
                    break
        out += block[i:i + length]
        i += length
        if i >= n:
            break
        offset = block[i] | block[i + 1] << 8
        i += 2
        length = token & 15
        if length == 15:
            while True:
                more = block[i]
                i += 1
                length += more
                if more != 255:
                    break
        length += 4
        start = len(out) - offset
        if offset >= length:
            out += out[start:start + length]
        else:
            piece = bytes(out[start:])
            out += (piece * (length // offset + 1))[:length]
    if len(out) != size:
        raise ValueError(f"LZ4 block of {len(out)} bytes, {size} expected")
    return bytes(out)


def read(path, *names):
    """A list of the named arrays ("Points": the positions); arrays with components are lists of tuples."""
    with open(path, "rb") as file:
        data = file.read()
    start = data.index(b"<AppendedData")
    body = data.index(b"_", start) + 1
    head = data[:start].decode()
    result = []
    for name in names:
        tag = re.search(rf'<DataArray type="(\w+)" Name="{name}"[^>]*>', head)
        if not tag:
            raise KeyError(f"{path}: no array {name}")
        kind = {"Float64": "d", "Int32": "i", "UInt8": "B"}[tag[1]]
        components = int((re.search(r'NumberOfComponents="(\d+)"', tag[0]) or [0, 1])[1])
        at = body + int(re.search(r'offset="(\d+)"', tag[0])[1])
        count, size, last = struct.unpack_from("<3Q", data, at)
        sizes = struct.unpack_from(f"<{count}Q", data, at + 24)
        at += 24 + 8 * count
        raw = b""
        for block, packed in enumerate(sizes):
            full = last if block == count - 1 and last else size
            raw += _lz4(data[at:at + packed], full)
            at += packed
        values = array.array(kind, raw)
        if sys.byteorder != "little":
            values.byteswap()
        result.append(list(zip(*[iter(values)] * components)) if components > 1 else list(values))
    return result
