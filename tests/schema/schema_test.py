# SPDX-FileCopyrightText: gudgeon contributors
# SPDX-License-Identifier: Apache-2.0
#
# schema_test.py PROGRAM SOURCE: holds the JSON schema of model files to what the reader does. Every model file of the
# examples and tests that the program reads passes it, as does its resolved model, which has every key; what has an
# unknown key, a wrong kind of value or a number out of range does not; and every default of the schema is a value that
# the program accepts.
import copy
import json
import pathlib
import subprocess
import sys
import tomllib

import jsonschema

program, source = sys.argv[1], pathlib.Path(sys.argv[2])
UNKNOWN_KEY = "no_such_key"
ANY_NAMES = {"constants", "set"}  # keys whose tables have names of the user's own
n_checks = {"files": 0, "resolved": 0, "unknown keys": 0, "wrong kinds": 0, "out of range": 0, "defaults": 0}


def run(*arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60)


def fail(message):
    sys.exit(f"schema_test.py: {message}")


schema = json.loads(run("keys", "--schema").stdout)
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)


def demand_valid(model, what):
    error = jsonschema.exceptions.best_match(validator.iter_errors(model))
    if error:
        fail(f"{what}: {'.'.join(map(str, error.absolute_path))}: {error.message}")


def demand_invalid(model, what):
    if validator.is_valid(model):
        fail(f"{what} passes the schema")


def matching(part, value):
    """The tables of the schema that a value of the model is: follows references and types."""
    if "$ref" in part:
        return matching(schema["definitions"][part["$ref"].rsplit("/", 1)[1]], value)
    of_types = [one for one in part.get("allOf", []) if "if" in one]
    if of_types:
        meant = [one["then"] for one in of_types if jsonschema.Draft7Validator(one["if"]).is_valid(value)]
        return [table for one in meant for table in matching(one, value)]
    for several in ("anyOf", "allOf"):
        if several in part and "properties" not in part:
            return [table for one in part[several] for table in matching(one, value)]
    if not isinstance(value, dict) or "properties" not in part and "additionalProperties" not in part:
        return []
    return [part]


def walk(part, value, path=()):
    """Every table of the model with its path and its schema."""
    for table in matching(part, value):
        if not set(table.get("required", [])) <= value.keys():
            continue
        yield path, value, table
        for key, inner in value.items():
            below = table.get("properties", {}).get(key, table.get("additionalProperties"))
            if isinstance(below, dict):
                yield from walk(below, inner, (*path, key))


def changed(model, path, key, value):
    model = copy.deepcopy(model)
    table = model
    for part in path:
        table = table[part]
    table[key] = value
    return model


def break_tables(model, name):
    for path, value, table in walk(schema, model):
        if table.get("additionalProperties") is False:
            demand_invalid(changed(model, path, UNKNOWN_KEY, 1), f"{name}: {'.'.join(path)}.{UNKNOWN_KEY}")
            n_checks["unknown keys"] += 1
        for key, one in table.get("properties", {}).items():
            if key not in value or key in ANY_NAMES:
                continue
            demand_invalid(changed(model, path, key, {UNKNOWN_KEY: 1}), f"{name}: {'.'.join(path)}.{key} as a table")
            n_checks["wrong kinds"] += 1
            low = one.get("minimum", one.get("exclusiveMinimum"))
            if low is not None:
                demand_invalid(changed(model, path, key, low - 1), f"{name}: {'.'.join(path)}.{key} = {low - 1}")
                n_checks["out of range"] += 1


def try_defaults(file, model):
    overrides = []
    for path, value, table in walk(schema, model):
        for key, one in table.get("properties", {}).items():
            if "default" not in one or key in value or "deprecated" in one or "cases" in path:
                continue
            overrides += ["--set", f"{'.'.join((*path, key))}={one['default']}"]
            n_checks["defaults"] += 1
    outcome = run("check", str(file), *overrides)
    if outcome.returncode:
        fail(f"{file}: defaults of the schema are refused:\n{outcome.stdout}{outcome.stderr}")


for file in sorted([*source.glob("examples/**/*.toml"), *source.glob("tests/**/*.toml")]):
    check = run("check", "--resolved", str(file))
    if check.returncode:
        continue
    model = tomllib.loads(file.read_text())
    demand_valid(model, file)
    n_checks["files"] += 1
    resolved = check.stdout[check.stdout.index("\nname = ") :]  # notes on the model stand before it
    demand_valid(tomllib.loads(resolved), f"the resolved model of {file}")
    n_checks["resolved"] += 1
    break_tables(model, file.name)
    try_defaults(file, model)

print(", ".join(f"{count} {what}" for what, count in n_checks.items()))
# A walk that finds no tables to break would pass without trying anything.
for what, count in n_checks.items():
    if count < n_checks["files"]:
        fail(f"only {count} {what} were tried")
