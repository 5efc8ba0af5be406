// Holds a shader as one text, ready for the front end: the result of the readers of sources and of SPIR-V files.
#pragma once

#include <string>
#include <vector>

namespace Drydock
{

struct FShaderSource
{
	std::string Text;
	std::vector<std::string> Files;   // on disk, in order of first reading
	std::vector<std::string> Strings; // texts that the shader prints, by number (ShaderPrints.h)
	std::string Fingerprint;          // hash of all that was read, before macros; of a module of SPIR-V: empty
};

} // namespace Drydock
