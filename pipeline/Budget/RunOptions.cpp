// Names the folder that a run writes into when nobody names one.
#include "Budget/RunOptions.h"

#include <filesystem>

namespace Drydock
{

DRYDOCK_DEFINE_COPIES(FRunOptions)

std::string GetDefaultOutputFolder(const std::string& ConfigFile)
{
	return (std::filesystem::path("out") / std::filesystem::path(ConfigFile).stem()).string();
}

} // namespace Drydock
