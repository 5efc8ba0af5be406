// The registry of extension types, and the names of the hooks that they can be given to.
#include "ExtensionFactory.h"

#include "RangeTools.h"

#include <map>

namespace Drydock
{

namespace
{

/** Never destroyed: libraries unregister at the very end of the program. */
std::map<std::string, FExtensionFactory>& GetExtensionRegistry()
{
	static auto* const Factories = new std::map<std::string, FExtensionFactory>;
	return *Factories;
}

/** By EPostProcessingPass. */
constexpr const char* PassNames[] = {"BeforeDOF", "AfterDOF", "TranslucencyAfterDOF", "SSRInput", "ReplacingTonemapper",
	"MotionBlur", "Tonemap", "FXAA", "SMAA", "VisualizeDepthOfField"};
static_assert(std::size(PassNames) == static_cast<size_t>(ISceneViewExtension::EPostProcessingPass::MAX));

} // namespace

bool RegisterExtensionFactory(FExtensionFactory Factory)
{
	const std::string Type = Factory.Type;
	Factory.Owner = MakeCodeOwner("extension type " + Type);
	if (GetExtensionRegistry().emplace(Type, std::move(Factory)).second)
	{
		return true;
	}
	UE_LOG(LogTemp, Warning, "Extension type %s is registered twice; the first one stays", Type.c_str());
	return false;
}

void UnregisterExtensionFactory(const std::string& Type)
{
	GetExtensionRegistry().erase(Type);
}

const FExtensionFactory* FindExtensionFactory(const std::string& Type)
{
	const auto Found = GetExtensionRegistry().find(Type);
	return Found == GetExtensionRegistry().end() ? nullptr : &Found->second;
}

std::vector<const FExtensionFactory*> GetExtensionFactories()
{
	return ToVector<const FExtensionFactory*>(GetExtensionRegistry(), [](const auto& Each) { return &Each.second; });
}

const char* GetPassName(ISceneViewExtension::EPostProcessingPass Pass)
{
	check(Pass < ISceneViewExtension::EPostProcessingPass::MAX);
	return PassNames[static_cast<size_t>(Pass)];
}

std::optional<ISceneViewExtension::EPostProcessingPass> FindPassByName(const std::string& Name)
{
	for (size_t Index = 0; Index < std::size(PassNames); ++Index)
	{
		if (Name == PassNames[Index])
		{
			return static_cast<ISceneViewExtension::EPostProcessingPass>(Index);
		}
	}
	return {};
}

std::vector<std::string> GetPassNames()
{
	return {std::begin(PassNames), std::end(PassNames)};
}

} // namespace Drydock
