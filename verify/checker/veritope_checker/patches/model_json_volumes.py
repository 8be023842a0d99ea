# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Volumes in JSON (docs/formats/spline-json.md), for reading-rule-faces.md."""
from ..common.errors import Refused
from .model_maps import Volume, last_axis_first
from .star_box_read import entities_of, read_json, read_map, typed

def read_json_volumes(data):
    """The volumes of a file that has no other entities."""
    return volumes_of(read_json(data))

def volumes_of(top):
    """The volumes of a model that is this value and has no other entities."""
    return entities_of(top, {"volume": read_volume}, ())

def read_volume(shape):
    entity, periodic, sizes, points = read_map(shape, "volume", 3)
    if any([typed(is_periodic, bool) for is_periodic in periodic]):
        raise Refused("a periodic axis does not begin and end with equal knots")
    return Volume(entity.degrees, entity.knots, entity.rational, entity.dimension, last_axis_first(points, sizes))
