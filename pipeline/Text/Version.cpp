// Holds the version and the commit that the build gives.
#include "Text/Version.h"

namespace Drydock
{

const char* GetVersion()
{
	return DRYDOCK_VERSION;
}

const char* GetCommit()
{
	return DRYDOCK_COMMIT;
}

} // namespace Drydock
