// The numbers of the messages of `drydock matrix`. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EMatrixError
{
	ErrorMatrixVersions = 1110, // --versions names none, or one that drydock does not know
	ErrorMatrixFolder = 1111,   // a folder with nothing of a plugin in it
	ErrorMatrixCompiler = 1112, // no C++ compiler
	ErrorMatrixFrame = 1113,    // the frame that is run where no config is given is not where it was installed
	ErrorMatrixProgram = 1114,  // the program cannot be started for a version
};

} // namespace Drydock
