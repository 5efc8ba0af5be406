// Resolves the paths of a config.
#include "Config/Config.h"

#include "RangeTools.h"

#include <filesystem>

namespace Drydock
{

DRYDOCK_DEFINE_COPIES(FConfig)

const FEngineProfile& FConfig::GetEngineProfile() const
{
	const FEngineProfile* const Row = FindEngineProfile(Engine.Value);
	return Row != nullptr ? *Row : GetDefaultEngineProfile();
}

std::string FConfig::Resolve(const std::string& Path) const
{
	const std::filesystem::path Given(Path);
	return Given.is_absolute() ? Path : (std::filesystem::path(File).parent_path() / Given).lexically_normal().string();
}

bool HasErrors(const std::vector<FDiagnostic>& Diagnostics)
{
	return Contains(Diagnostics, ESeverity::Error, &FDiagnostic::Severity);
}

} // namespace Drydock
