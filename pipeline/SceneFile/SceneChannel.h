// A channel of a scene file, as reports list it.
#pragma once

#include <string>

namespace Drydock
{

struct FSceneChannel
{
	std::string Name; // in the file
	bool bDecoded = false;
};

} // namespace Drydock
