#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the risk of planned motions with how many of them touched, from JSON files of smore_experiment.

    plot_reliability.py --output FILE.png RESULT.json [RESULT.json ...]

Motions of all files are put together and sorted into ten bins of risk. A dot stands at a bin's mean risk
and its share of motions that touched, with a 95 % interval (Wilson's); bars count the motions. The
expected calibration error is the mean distance of the dots from the diagonal, weighted by the motions.
It prints this, the log-loss (no outcome counts as less likely than a thousandth), and what the base rate of
the motions would have.
"""
import argparse
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from user_files import read_result, save_picture

BINS = 10
LEAST = 1e-3  # of what was forecast for the outcome
QUANTILE = 1.96  # of the normal distribution, for 95 %
WITHOUT_RISK = ("paper", "cspace")
BLUE = "#3b6fb6"


def arguments():
    parser = argparse.ArgumentParser(description="Draws the reliability diagram of planned motions.")
    parser.add_argument("results", nargs="+", help="JSON files of smore_experiment")
    parser.add_argument("--output", required=True, help="picture to write")
    return parser.parse_args()


def read(files):
    """Risks, and whether each motion touched."""
    results = [read_result(file) for file in files]
    for file, result in zip(files, results):
        if result["method"] in WITHOUT_RISK:
            raise ValueError(f"{file}: the method {result['method']} states no risk")
    trials = [trial for result in results for trial in result["trials"]]
    motions = [motion for trial in trials for motion in trial["motions"]]
    if not motions:
        raise ValueError("there is no planned motion in the results")
    return np.array([m["risk"] for m in motions]), np.array([m["touched"] for m in motions], dtype=float)


def binned(risk, touched):
    """Of each bin that is not empty: mean risk, share that touched, number of motions."""
    place = np.minimum((risk * BINS).astype(int), BINS - 1)
    bins = [place == i for i in range(BINS) if np.any(place == i)]
    return np.array([(risk[b].mean(), touched[b].mean(), b.sum()) for b in bins]).T


def wilson(share, count):
    """Lower and upper end of the interval for a share of `count`."""
    squared = QUANTILE**2
    center = (share + squared / (2 * count)) / (1 + squared / count)
    half = np.sqrt(share * (1 - share) / count + squared / (4 * count**2)) / (1 + squared / count) * QUANTILE
    return center - half, center + half


def log_losses(risk, touched):
    """Of the stated risks, and of the base rate of the other motions, so that none tells its own outcome."""
    constant = (touched.sum() - touched + 0.5) / len(touched)
    likely = [np.where(touched > 0.5, forecast, 1.0 - forecast) for forecast in (risk, constant)]
    return [-np.mean(np.log(np.clip(of_one, LEAST, 1.0))) for of_one in likely]


def draw(risk, touched):
    stated, found, count = binned(risk, touched)
    error = np.sum(np.abs(stated - found) * count) / len(risk)
    low, high = wilson(found, count)
    figure, (axes, below) = plt.subplots(
        2, 1, figsize=(4.8, 6.0), sharex=True, gridspec_kw={"height_ratios": (3, 1)}, constrained_layout=True
    )
    axes.plot([0, 1], [0, 1], color="#7a7a7a", linestyle="--", linewidth=1.0)
    axes.errorbar(stated, found, yerr=np.clip([found - low, high - found], 0, None), fmt="o", color=BLUE, capsize=3)
    axes.set(ylabel="share that touched", xlim=(0, 1), ylim=(-0.02, 1.02))
    axes.set_title(f"{len(risk)} planned motions, expected calibration error {error:.3f}", fontsize=10)
    below.hist(risk, bins=BINS, range=(0, 1), color=BLUE, alpha=0.6)
    below.set(xlabel="risk that the plan stated", ylabel="motions")
    return figure, error


def main():
    options = arguments()
    try:
        risk, touched = read(options.results)
    except (OSError, ValueError, KeyError) as error:
        print(f"plot_reliability.py: no results of planned motions: {error!r}", file=sys.stderr)
        return 1
    figure, error = draw(risk, touched)
    save_picture(figure, options.output, dpi=120)
    print(f"{len(risk)} motions, {touched.mean():.3f} touched, mean risk {risk.mean():.3f}, "
          f"expected calibration error {error:.3f}")
    print("log-loss {:.3f}, of the base rate {:.3f}".format(*log_losses(risk, touched)))
    for stated, found, count in binned(risk, touched).T:
        print(f"  risk {stated:.2f}: touched {found:.2f} of {count:.0f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
