// Keeps the defines of a permutation, and maps the shipped shader directories.
#include "ShaderCore.h"

#include "InstallPaths.h"
#include "ShaderDirectories.h"
#include "TextTools.h"

#include <mutex>

namespace
{

size_t GNumShippedShaderDirectories = 0;

} // namespace

void AddShaderSourceDirectoryMapping(const FString& VirtualShaderDirectory, const FString& RealShaderDirectory)
{
	Drydock::MapShippedShaders();
	Drydock::AddShaderDirectory(*VirtualShaderDirectory, *RealShaderDirectory);
}

const TMap<FString, FString>& AllShaderSourceDirectoryMappings()
{
	Drydock::MapShippedShaders();
	static TMap<FString, FString> Mappings;
	Mappings.Reset();
	for (const Drydock::FShaderDirectory& Mapping : Drydock::GetShaderDirectories())
	{
		Mappings.Add(FString(Mapping.Virtual), FString(Mapping.Real));
	}
	return Mappings;
}

void ResetAllShaderSourceDirectoryMappings()
{
	Drydock::MapShippedShaders();
	Drydock::ForgetShaderDirectories(GNumShippedShaderDirectories);
}

void FShaderCompilerEnvironment::SetDefine(const TCHAR* Name, const TCHAR* Value)
{
	for (auto& [DefinedName, DefinedValue] : Defines)
	{
		if (DefinedName == Name)
		{
			DefinedValue = Value;
			return;
		}
	}
	Defines.emplace_back(Name, Value);
}

void FShaderCompilerEnvironment::SetDefine(const TCHAR* Name, bool Value)
{
	SetDefine(Name, Value ? TEXT("1") : TEXT("0"));
}

void FShaderCompilerEnvironment::SetDefine(const TCHAR* Name, int32 Value)
{
	SetDefine(Name, std::to_string(Value).c_str());
}

void FShaderCompilerEnvironment::SetDefine(const TCHAR* Name, uint32 Value)
{
	SetDefine(Name, std::to_string(Value).c_str());
}

void FShaderCompilerEnvironment::SetDefine(const TCHAR* Name, float Value)
{
	std::string Text = Drydock::FormatShortest(Value);
	if (Text.find_first_not_of("-0123456789") == std::string::npos)
	{
		Text += ".0";
	}
	SetDefine(Name, Text.c_str());
}

namespace Drydock
{

void MapPluginShaders(const std::string& VirtualDirectory, const std::string& RealDirectory)
{
	MapShippedShaders();
	AddShaderDirectory(VirtualDirectory, RealDirectory, true);
}

void MapShippedShaders()
{
	static std::once_flag Once;
	std::call_once(Once,
		[]
		{
			const std::string Root = FindShippedShaders();
			const std::string Passes = Root + "/passes/Shaders";
			AddShaderDirectory("/Engine", Root + "/rdg/graph/Shaders/Engine");
			AddShaderDirectory("/Engine/Private", Passes);
			AddShaderDirectory("/Project", Passes + "/Drydock");
			AddShaderDirectory("/Project", Passes);
			AddShaderDirectory("/Drydock", Root + "/rdg/graph/Shaders/Drydock");
			AddShaderDirectory("/Drydock/Private", Passes + "/Drydock");
			GNumShippedShaderDirectories = CountShaderDirectories();
		});
}

} // namespace Drydock
