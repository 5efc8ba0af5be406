// Holds the version that the build gives.
#include "Text/Version.h"

namespace Drydock
{

const char* GetVersion()
{
	return DRYDOCK_VERSION;
}

} // namespace Drydock
