# SPDX-License-Identifier: BSD-3-Clause
"""The best that a choice of touches could do: who knows beforehand where each of many touches will end takes, one after
the other, the one that covers most of what is left of a surface."""
import numpy as np

FARTHEST = 1.0  # distance up to which touches may count for the surface around them [m]
HALVINGS = 20


def distance_for(surface, trials, wanted):
    """Distance within which the places of a trial cover this share of the surface, in the mean of the trials [m]."""
    low, high = 0.0, FARTHEST
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        reached = np.mean([surface.share_near(places, middle) for places in trials])
        low, high = (middle, high) if reached < wanted else (low, middle)
    return high


def fewest(surface, places, distance, wanted):
    """How many places, each the best after those before it, cover this share of the surface; None where all do not."""
    within = np.array([surface.near(place, distance) for place in places])
    found = np.zeros(len(surface.points), dtype=bool)
    for count in range(len(places) + 1):
        if surface.share(found) >= wanted:
            return count
        gains = (within & ~found) @ surface.areas
        found |= within[np.argmax(gains)]
    return None
