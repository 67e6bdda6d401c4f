# Messages, services, actions and dynamic parameters of this package.

add_message_files(DIRECTORY msg FILES ContactObservation.msg Evidence.msg EvidenceSource.msg LineOfAction.msg
  Prior.msg SensingEvent.msg SensingEvents.msg)
add_service_files(DIRECTORY srv FILES CheckPose.srv InsertPrior.srv LoadBelief.srv PlanPath.srv PlanTouch.srv
  SaveBelief.srv SaveMaps.srv TwinMaps.srv)
add_action_files(DIRECTORY action FILES Retrieve.action)
# Headers and Python modules only.
generate_messages(
  DEPENDENCIES actionlib_msgs geometry_msgs nav_msgs octomap_msgs sensor_msgs std_msgs
  LANGS gencpp genpy)
generate_dynamic_reconfigure_options(cfg/Guard.cfg cfg/Mapping.cfg)
