# SPDX-License-Identifier: LGPL-3.0-or-later
"""The schema of the program's reports, and what in a document breaks it."""
import json

from support import ROOT

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCHEMA = json.loads((ROOT / "docs" / "report.schema.json").read_text())
DEFINITIONS = SCHEMA["$defs"]


def kinds():
    """The definition of each kind of document, by what such a document has under "schema"."""
    names = [row["$ref"].rsplit("/", 1)[1] for row in SCHEMA["oneOf"]]
    return {DEFINITIONS[name]["properties"]["schema"]["const"]: name for name in names}


def keys_of(name):
    """The keys of a definition, in the order in which reports have them."""
    return list(DEFINITIONS[name]["properties"])


def validator():
    return jsonschema.Draft202012Validator(SCHEMA)


def faults(document):
    """Each place that breaks the schema; without jsonschema none is found."""
    if jsonschema is None:
        return []
    one = jsonschema.Draft202012Validator({**SCHEMA, "oneOf": [{"$ref": f"#/$defs/{kinds()[document['schema']]}"}]})
    return [f"{error.json_path}: {error.message}" for error in one.iter_errors(document)]
