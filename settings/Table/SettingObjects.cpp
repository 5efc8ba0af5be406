// Keeps one object for each path and class.
#include "SettingObjects.h"

#include "TextTools.h"

#include <map>
#include <memory>
#include <mutex>

namespace Drydock
{

namespace
{

std::mutex ObjectsMutex;

/** Paths of all objects made here, whatever their class. */
std::map<const UObject*, std::string>& GetPaths()
{
	static std::map<const UObject*, std::string> Paths;
	return Paths;
}

/** "A" of "/Game/Folder/A.A". */
std::string GetObjectName(const std::string& Path)
{
	return Path.substr(Path.find_last_of("./") + 1);
}

template<typename T>
T* FindOrAdd(const std::string& Path)
{
	if (Path.empty() || Path == "None")
	{
		return nullptr;
	}
	static std::map<std::string, std::unique_ptr<T>> Objects;
	const std::lock_guard<std::mutex> Lock(ObjectsMutex);
	std::unique_ptr<T>& Object = Objects[Path];
	if (!Object)
	{
		Object = std::make_unique<T>();
		Object->SetFName(FName(GetObjectName(Path).c_str()));
		GetPaths()[Object.get()] = Path;
	}
	return Object.get();
}

} // namespace

UTexture2D* FindOrAddTexture(const std::string& Path)
{
	return FindOrAdd<UTexture2D>(Path);
}

UTextureCube* FindOrAddTextureCube(const std::string& Path)
{
	return FindOrAdd<UTextureCube>(Path);
}

UCurveFloat* FindOrAddCurve(const std::string& Path)
{
	return FindOrAdd<UCurveFloat>(Path);
}

UObject* FindOrAddObject(const std::string& Path)
{
	return FindOrAdd<UObject>(Path);
}

std::string GetObjectPath(const UObject* Object)
{
	if (Object == nullptr)
	{
		return "None";
	}
	const std::lock_guard<std::mutex> Lock(ObjectsMutex);
	const auto Found = GetPaths().find(Object);
	return Found != GetPaths().end() ? Found->second : std::string(*Object->GetName());
}

std::string StripObjectClass(const std::string& Reference)
{
	std::string Path = Reference;
	for (;;)
	{
		Path = Trim(Path);
		if (Path.size() >= 2 && Path.front() == '"' && Path.back() == '"')
		{
			Path = Path.substr(1, Path.size() - 2);
			continue;
		}
		const size_t Open = Path.find('\'');
		if (Open == std::string::npos || Open + 1 == Path.size() || Path.back() != '\'')
		{
			return Path;
		}
		Path = Path.substr(Open + 1, Path.size() - Open - 2);
	}
}

} // namespace Drydock
