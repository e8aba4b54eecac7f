# SPDX-License-Identifier: Apache-2.0
# Puts the packages of package-lock.json, and nothing else, into WORK/node_modules. Their install scripts stay unrun.
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json DESTINATION ${WORK})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
                WORKING_DIRECTORY ${WORK} RESULT_VARIABLE problem)
if(problem)
  message(FATAL_ERROR "npm ci cannot fetch the packages of the Studio's page: it needs the npm registry, or npm's "
                      "cache, the first time. Then build again.")
endif()
file(TOUCH ${WORK}/packages.stamp)
