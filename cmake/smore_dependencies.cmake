# Libraries that the package is built on. As each Linux distribution of some years tells of them in its own way,
# their targets are made here, alike everywhere.

find_package(Boost REQUIRED CONFIG COMPONENTS program_options)
find_package(Eigen3 REQUIRED)
find_package(Threads REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(octomap REQUIRED)
find_package(ompl REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(PkgConfig REQUIRED)

# smore_pkg_config(PREFIX MODULE [REQUIRED]): the target PkgConfig::PREFIX, which leaves the C++ standard to this
# package.
macro(smore_pkg_config prefix module)
  pkg_check_modules(${prefix} ${ARGN} IMPORTED_TARGET ${module})
  list(FILTER ${prefix}_CFLAGS_OTHER EXCLUDE REGEX "^-std=")
  if(${prefix}_FOUND)
    set_target_properties(PkgConfig::${prefix} PROPERTIES
      INTERFACE_COMPILE_OPTIONS "${${prefix}_CFLAGS_OTHER}")
  endif()
endmacro()
smore_pkg_config(ASSIMP assimp REQUIRED)
smore_pkg_config(BULLET bullet-float64 REQUIRED)
smore_pkg_config(FCL fcl REQUIRED)
smore_pkg_config(URDFDOM urdfdom REQUIRED)
# Bags bring pluginlib, and Debian's asks for a Python of its own: let it be the one that catkin has found. Not a
# component of catkin, so that only what reads bags sees what comes with them.
if(NOT DEFINED Python3_EXECUTABLE)
  set(Python3_EXECUTABLE ${PYTHON_EXECUTABLE})
endif()
find_package(rosbag_storage REQUIRED)
# For the two nodes alone whose parameters may change while they run.
find_package(dynamic_reconfigure REQUIRED)

# For the panel in rviz, which is left out where the headers of rviz are not installed.
find_package(rviz QUIET)
find_package(Qt5 QUIET COMPONENTS Widgets Test)

# For the simulator as a module of Python, which is left out where pybind11 or Python's headers are not installed.
# Debian 13's catkin asks for `Python`, and then pybind11 takes that one.
if(NOT DEFINED Python_EXECUTABLE)
  set(Python_EXECUTABLE ${PYTHON_EXECUTABLE})
endif()
find_package(Python QUIET COMPONENTS Interpreter Development)
find_package(pybind11 QUIET)

# Of Bullet's extras, but free of Bullet.
find_path(HACD_INCLUDE_DIR HACD/hacdHACD.h PATH_SUFFIXES bullet)
find_library(HACD_LIBRARY HACD-float64)
