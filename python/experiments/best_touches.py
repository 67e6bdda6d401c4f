# SPDX-License-Identifier: BSD-3-Clause
"""The best that a choice of touches could do: who knows beforehand where each of many touches will end takes, one after
the other, the one that covers most of what is left of a surface."""
import numpy as np

FARTHEST = 1.0  # distance up to which touches may count for the surface around them [m]
HALVINGS = 20


def covered(surface, places, distance):
    """Of each place, which points of the surface lie within a distance [m]."""
    return np.array([np.linalg.norm(surface.points - place, axis=1) <= distance for place in places])


def share(surface, points):
    """Of the surface, by area, that some of its points stand for."""
    return surface.areas[points].sum() / surface.areas.sum()


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
    within = covered(surface, places, distance)
    found = np.zeros(len(surface.points), dtype=bool)
    for count in range(len(places) + 1):
        if share(surface, found) >= wanted:
            return count
        gains = (within & ~found) @ surface.areas
        found |= within[np.argmax(gains)]
    return None
