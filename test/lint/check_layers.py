#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A layer includes only itself and layers below it, and only ros/ and rviz/ include ROS headers."""
import re

from project import CODE_FOLDERS, ROOT, code_files, report, say

# What each layer may use besides itself (docs/architecture.md).
BELOW = {
    "common": set(),
    "contact": {"common"},
    "scenario": {"common"},
    "mapping": {"common", "contact", "scenario"},
    "planning": {"common", "contact", "scenario", "mapping"},
    "kinematics": {"common", "scenario"},
    "simulation": {"common", "contact", "scenario", "kinematics"},
    "retrieval": {"common", "contact", "scenario", "mapping", "planning"},
}
BELOW["experiment"] = set(BELOW) | {"retrieval"}
BELOW["ros"] = set(BELOW)
BELOW["python"] = BELOW["ros"]
BELOW["rviz"] = BELOW["ros"] | {"ros"}

ROS_LAYERS = {"ros", "rviz"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
ROS_HEADER = re.compile(
    r"^(ros|tf2?|tf2_\w+|\w+_msgs|std_srvs|actionlib|rosbag|roslib|rosgraph|rviz|urdf|message_filters|"
    r"diagnostic_updater|dynamic_reconfigure|interactive_markers|pluginlib|nodelet|xmlrpcpp)/"
    r"|^XmlRpc\w*\.h$"
)


def layer_of(path):
    """The layer that a file belongs to: include/smore/LAYER, src/LAYER, test/LAYER."""
    parts = path.relative_to(ROOT).parts
    layer = parts[2] if parts[0] == "include" else parts[1]
    return layer if layer in BELOW else None


def included_layer(header):
    parts = header.split("/")
    return parts[1] if parts[0] == "smore" and len(parts) > 2 else None


def problem(layer, tested, header):
    if layer in ROS_LAYERS:
        allowed = BELOW[layer] | {layer}
    elif ROS_HEADER.match(header) or included_layer(header) in ROS_LAYERS:
        return f"{layer} includes the ROS header {header}"
    else:
        allowed = BELOW[layer] | {layer}
    used = included_layer(header)
    # Tests may look at a layer from above (a simulator as the source of contacts, say).
    if used in BELOW and used not in allowed and not tested:
        return f"{layer} includes {header}, which is not below it"
    if used is not None and used not in BELOW:
        return f"{layer} includes {header} of an unknown layer"
    return None


def findings_of(path):
    layer = layer_of(path)
    if layer is None:
        return
    tested = path.relative_to(ROOT).parts[0] in ("test", "benchmark")
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        found = problem(layer, tested, match.group(1)) if match else None
        if found:
            yield say(path, number, found)


def main():
    paths = code_files(CODE_FOLDERS)
    report([finding for path in paths for finding in findings_of(path)], len(paths))


if __name__ == "__main__":
    main()
