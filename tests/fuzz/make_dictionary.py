#!/usr/bin/env python3
"""Prints a libFuzzer dictionary of the keys and words of scene files: abut schema | make_dictionary.py"""
import json
import sys

words = set()


def visit(node):
    if isinstance(node, dict):
        if isinstance(node.get("properties"), dict):
            words.update(node["properties"])
        words.update(value for value in node.get("enum", []) if isinstance(value, str))
        if isinstance(node.get("const"), str):
            words.add(node["const"])
        for value in node.values():
            visit(value)
    elif isinstance(node, list):
        for value in node:
            visit(value)


visit(json.load(sys.stdin))
for word in sorted(words):
    print('"\\"' + word + '\\""')
for unit in ("m", "mm", "s", "us", "Pa", "GPa", "m/s", "m/s^2", "kg/m^3", "deg", "rad/s", "K", "N", "Pa/m", "Pa*s/m"):
    print('"1 ' + unit + '"')
