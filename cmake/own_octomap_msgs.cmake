# octomap_msgs/ of this repository as a package beside ours, in the same devel and install space.

#catkin_lint: ignore duplicate_cmd subproject
add_subdirectory(octomap_msgs)

# ROS's tools look no deeper than the first package.xml: the devel space tells them of this package.
set(marker ${CATKIN_DEVEL_PREFIX}/.catkin)
file(READ ${marker} packages)
if(NOT "${PROJECT_SOURCE_DIR}/octomap_msgs" IN_LIST packages)
  file(APPEND ${marker} ";${PROJECT_SOURCE_DIR}/octomap_msgs")
endif()
