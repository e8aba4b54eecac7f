# SPDX-License-Identifier: Apache-2.0
# Places of an installation, relative to its prefix. They are compiled in, so that a program finds its parts relative
# to itself: src/ionskin/base/system/installation.hpp.
set(IONSKIN_BIN_FOLDER bin)
set(IONSKIN_LIBEXEC_FOLDER libexec/ionskin)
set(IONSKIN_LIBRARY_FOLDER lib)
set(IONSKIN_DATA_FOLDER share/ionskin)
set(IONSKIN_PYTHON_FOLDER lib/python3/dist-packages)
set(IONSKIN_DOC_FOLDER share/doc/ionskin)
set(IONSKIN_CMAKE_FOLDER lib/cmake/ionskin)
set(IONSKIN_INCLUDE_FOLDER include/ionskin)
