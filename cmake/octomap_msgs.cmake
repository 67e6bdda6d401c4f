# Headers and Python modules of octomap_msgs from definitions of our own. Leaves octomap_msgs_FOUND and
# what message generation reads, as the package itself would, and the target octomap_msgs_headers.

set(definitions ${PROJECT_SOURCE_DIR}/cmake/octomap_msgs)
set(include_flags -Ioctomap_msgs:${definitions}/msg -Istd_msgs:${std_msgs_DIR}/../msg)

set(headers ${CATKIN_DEVEL_PREFIX}/include/octomap_msgs)
set(modules ${CATKIN_DEVEL_PREFIX}/${CATKIN_GLOBAL_PYTHON_DESTINATION}/octomap_msgs)
file(MAKE_DIRECTORY ${headers} ${modules}/msg ${modules}/srv)
file(WRITE ${modules}/__init__.py "")

# octomap_definition(KIND NAME GENERATOR): the header and the module of one message or service.
function(octomap_definition kind name generator)
  set(file ${definitions}/${kind}/${name}.${kind})
  add_custom_command(
    OUTPUT ${headers}/${name}.h ${modules}/${kind}/_${name}.py
    DEPENDS ${file} ${definitions}/msg/Octomap.msg
    COMMAND ${PYTHON_EXECUTABLE} ${GENCPP_BIN} ${file} ${include_flags} -p octomap_msgs -o ${headers}
      -e ${GENCPP_TEMPLATE_DIR}
    COMMAND ${PYTHON_EXECUTABLE} ${generator} ${file} ${include_flags} -p octomap_msgs
      -o ${modules}/${kind}
    COMMAND ${PYTHON_EXECUTABLE} ${generator} --initpy -p octomap_msgs -o ${modules}/${kind}
    COMMENT "Generating octomap_msgs/${name}"
    VERBATIM)
endfunction()
octomap_definition(msg Octomap ${GENMSG_PY_BIN})
octomap_definition(srv GetOctomap ${GENSRV_PY_BIN})
add_custom_target(octomap_msgs_headers ALL
  DEPENDS ${headers}/Octomap.h ${headers}/GetOctomap.h)

install(DIRECTORY ${headers}/
  DESTINATION ${CATKIN_GLOBAL_INCLUDE_DESTINATION}/octomap_msgs)
install(DIRECTORY ${modules}/
  DESTINATION ${CATKIN_GLOBAL_PYTHON_DESTINATION}/octomap_msgs)

# What message generation looks for in a package that it depends on.
set(octomap_msgs_FOUND TRUE)
file(WRITE ${CATKIN_DEVEL_PREFIX}/share/octomap_msgs/cmake/octomap_msgs-msg-paths.cmake
  "set(octomap_msgs_MSG_INCLUDE_DIRS ${definitions}/msg)\nset(octomap_msgs_MSG_DEPENDENCIES std_msgs)\n")
