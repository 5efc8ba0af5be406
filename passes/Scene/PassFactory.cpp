// The registry of pass types.
#include "PassFactory.h"

#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Never destroyed: libraries unregister at the very end of the program. */
std::map<std::string, FPassFactory>& GetPassRegistry()
{
	static auto* const Factories = new std::map<std::string, FPassFactory>;
	return *Factories;
}

} // namespace

bool RegisterPassFactory(FPassFactory Factory)
{
	const std::string Type = Factory.Type;
	Factory.Owner = MakeCodeOwner("pass type " + Type);
	if (GetPassRegistry().emplace(Type, std::move(Factory)).second)
	{
		return true;
	}
	UE_LOG(LogTemp, Warning, "Pass type %s is registered twice; the first one stays", Type.c_str());
	return false;
}

void UnregisterPassFactory(const std::string& Type)
{
	GetPassRegistry().erase(Type);
}

const FPassFactory* FindPassFactory(const std::string& Type)
{
	auto& Registry = GetPassRegistry();
	auto Found = Registry.find(Type);
	if (Found == Registry.end())
	{
		Found = std::ranges::find_if(
			Registry, [&](const auto& Each) { return ToLowerCase(Each.first) == ToLowerCase(Type); });
	}
	return Found == Registry.end() ? nullptr : &Found->second;
}

std::vector<const FPassFactory*> GetPassFactories()
{
	return ToVector<const FPassFactory*>(GetPassRegistry(), [](const auto& Each) { return &Each.second; });
}

} // namespace Drydock
