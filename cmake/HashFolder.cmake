# Writes the hash of all files below FOLDER into OUT, as a C++ string; leaves OUT alone where it is the same.
#   cmake -DFOLDER=... -DOUT=... -P HashFolder.cmake
file(GLOB_RECURSE Files RELATIVE ${FOLDER} ${FOLDER}/*)
list(SORT Files)
set(All "")
foreach(File IN LISTS Files)
	file(SHA256 ${FOLDER}/${File} Hash)
	string(APPEND All "${File} ${Hash}\n")
endforeach()
string(SHA256 Hash "${All}")
file(CONFIGURE OUTPUT ${OUT} CONTENT "\"${Hash}\"\n")
