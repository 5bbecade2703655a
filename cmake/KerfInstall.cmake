# What scripts/package puts where. The programs look for their helpers and for the machine module beside themselves, so
# they live in one folder; /usr/bin has links to them.
set(KERF_LIBEXEC lib/kerf)
set(KERF_DATA ${CMAKE_SOURCE_DIR}/resources/package)

function(kerf_install_program target component)
  install(TARGETS ${target}
    RUNTIME DESTINATION ${KERF_LIBEXEC} COMPONENT ${component}
    LIBRARY DESTINATION ${KERF_LIBEXEC} COMPONENT ${component})
endfunction()

foreach(program kerf kerf-console kerf-sensors kerf-gateway)
  kerf_install_program(${program} console)
  install(CODE "
    file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin\")
    file(CREATE_LINK ../${KERF_LIBEXEC}/${program} \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/${program}\" SYMBOLIC)"
    COMPONENT console)
  # Made by scripts/package from the program's own --help.
  install(FILES ${CMAKE_BINARY_DIR}/man/${program}.1.gz DESTINATION share/man/man1 COMPONENT console OPTIONAL)
endforeach()
install(FILES ${KERF_DATA}/kerf.desktop DESTINATION share/applications COMPONENT console)
install(FILES ${KERF_DATA}/kerf.svg DESTINATION share/icons/hicolor/scalable/apps COMPONENT console)
install(FILES ${KERF_DATA}/kerf.bash-completion DESTINATION share/bash-completion/completions RENAME kerf COMPONENT console)
foreach(program kerf-console kerf-sensors kerf-gateway)
  install(CODE "file(CREATE_LINK kerf \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/bash-completion/completions/${program}\" SYMBOLIC)"
    COMPONENT console)
endforeach()
install(FILES ${KERF_DATA}/kerf-console.service DESTINATION lib/systemd/user COMPONENT console)
install(FILES ${CMAKE_SOURCE_DIR}/resources/sensors/example.json DESTINATION share/kerf/sensors COMPONENT console)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/rehearsals DESTINATION share/kerf COMPONENT console)

kerf_install_program(kerf-linuxcnc linuxcnc)
if(TARGET kerf-hal)
  kerf_install_program(kerf-hal linuxcnc)
  install(CODE "
    file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin\")
    file(CREATE_LINK ../${KERF_LIBEXEC}/kerf-hal \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/kerf-hal\" SYMBOLIC)"
    COMPONENT linuxcnc)
  install(FILES ${CMAKE_BINARY_DIR}/man/kerf-hal.1.gz DESTINATION share/man/man1 COMPONENT linuxcnc OPTIONAL)
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/resources/linuxcnc DESTINATION share/kerf COMPONENT linuxcnc)
foreach(pair console:kerf linuxcnc:kerf-linuxcnc)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  install(FILES ${CMAKE_BINARY_DIR}/package/copyright ${CMAKE_BINARY_DIR}/package/changelog.gz
    DESTINATION share/doc/${package} COMPONENT ${component} OPTIONAL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL console linuxcnc)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "Kerf maintainers <maintainers@kerf.invalid>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CONSOLE_PACKAGE_NAME kerf)
set(CPACK_DEBIAN_CONSOLE_FILE_NAME kerf_${PROJECT_VERSION}_amd64.deb)
set(CPACK_DEBIAN_CONSOLE_PACKAGE_DEPENDS "libqt6sql6-sqlite, fonts-noto-core")
set(CPACK_DEBIAN_CONSOLE_PACKAGE_RECOMMENDS "fonts-noto-cjk, openssl")
set(CPACK_DEBIAN_CONSOLE_DESCRIPTION "Operator console and adaptive control for CNC machine tools
 Runs beside the machine, closes adaptive loops that ordinary controls
 leave open (boring, milling, turning, thermal drift, rigid tapping) and keeps
 the measurements of every part. With a built-in simulator.")
set(CPACK_DEBIAN_LINUXCNC_PACKAGE_NAME kerf-linuxcnc)
set(CPACK_DEBIAN_LINUXCNC_FILE_NAME kerf-linuxcnc_${PROJECT_VERSION}_amd64.deb)
set(CPACK_DEBIAN_LINUXCNC_PACKAGE_DEPENDS "kerf (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LINUXCNC_PACKAGE_RECOMMENDS linuxcnc-uspace)
set(CPACK_DEBIAN_LINUXCNC_DESCRIPTION "Kerf on LinuxCNC: bridge, machine module, HAL files
 The HAL component that LinuxCNC loads, the module with which the console of
 Kerf talks to it, and the HAL and G-code files of both.")
include(CPack)
