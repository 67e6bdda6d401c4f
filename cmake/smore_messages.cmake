# Messages, services and actions of this package, and those of octomap_msgs where it is not installed.

# Debian does not package octomap_msgs. These definitions have the same type names and checksums, so
# that programs built against the package can talk to ours.
find_package(octomap_msgs QUIET)
if(NOT octomap_msgs_FOUND)
  include(${CMAKE_CURRENT_LIST_DIR}/octomap_msgs.cmake)
endif()

add_message_files(DIRECTORY msg FILES ContactObservation.msg Evidence.msg LineOfAction.msg)
add_service_files(DIRECTORY srv FILES CheckPose.srv LoadBelief.srv PlanPath.srv PlanTouch.srv SaveBelief.srv
  SaveMaps.srv TwinMaps.srv)
add_action_files(DIRECTORY action FILES Retrieve.action)
# Headers and Python modules only.
generate_messages(
  DEPENDENCIES actionlib_msgs geometry_msgs nav_msgs octomap_msgs std_msgs
  LANGS gencpp genpy)
if(TARGET octomap_msgs_headers)
  add_dependencies(${PROJECT_NAME}_generate_messages octomap_msgs_headers)
endif()
