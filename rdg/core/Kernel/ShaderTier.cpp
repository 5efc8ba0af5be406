// Keeps the registered shader tier, and tells files apart by their canonical paths.
#include "ShaderTier.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace Drydock
{

namespace
{

IShaderTier* GTier = nullptr;

std::string MakeCanonical(const std::string& Path)
{
	std::error_code Error;
	const std::filesystem::path Canonical = std::filesystem::canonical(Path, Error);
	return Error ? Path : Canonical.string();
}

} // namespace

FShaderFiles::FShaderFiles(const std::vector<std::string>& Paths)
{
	for (const std::string& Path : Paths)
	{
		Canonical.insert(MakeCanonical(Path));
	}
}

bool FShaderFiles::IsReadBy(const std::vector<std::string>& Files) const
{
	const auto IsOne = [this](const std::string& File)
	{
		const auto [Known, bNew] = Asked.try_emplace(File, false);
		Known->second = bNew ? Canonical.contains(MakeCanonical(File)) : Known->second;
		return Known->second;
	};
	return std::any_of(Files.begin(), Files.end(), IsOne);
}

void RegisterShaderTier(IShaderTier& Tier)
{
	GTier = &Tier;
}

IShaderTier& GetShaderTier()
{
	if (!GTier)
	{
		throw std::logic_error("this program is linked without the shader tier: it can run no .usf");
	}
	return *GTier;
}

} // namespace Drydock
