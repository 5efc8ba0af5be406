// Defines of a permutation and the shipped shader directories. Source: drydock.
#include "ShaderCompiler.h"

#include <charconv>
#include <dlfcn.h>
#include <filesystem>
#include <mutex>

#include "ShaderCore.h"

void AddShaderSourceDirectoryMapping(const FString& VirtualShaderDirectory, const FString& RealShaderDirectory)
{
	Drydock::MapShippedShaders();
	Drydock::AddShaderDirectory(*VirtualShaderDirectory, *RealShaderDirectory);
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
	char Buffer[64];
	std::string Text(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Value).ptr);
	if (Text.find_first_not_of("-0123456789") == std::string::npos)
	{
		Text += ".0";
	}
	SetDefine(Name, Text.c_str());
}

namespace Drydock
{

namespace
{

/** The folder that the loaded libdrydock.so lies in. */
std::filesystem::path GetLibraryFolder()
{
	Dl_info Info{};
	if (dladdr(reinterpret_cast<const void*>(&MapShippedShaders), &Info) && Info.dli_fname)
	{
		std::error_code Ignored;
		return std::filesystem::weakly_canonical(Info.dli_fname, Ignored).parent_path();
	}
	return {};
}

/** The folder that holds rdg/Shaders and passes/Shaders: `<prefix>/share/drydock` for a library in `<prefix>/lib` or
 *  `<prefix>/lib/<triplet>`, the source tree for one that is not installed. */
std::filesystem::path FindShippedShaders()
{
	std::error_code Ignored;
	std::filesystem::path Folder = GetLibraryFolder();
	for (int32 Up = 0; Up < 2 && Folder.has_relative_path(); ++Up)
	{
		Folder = Folder.parent_path();
		if (std::filesystem::is_directory(Folder / "share" / "drydock" / "rdg" / "Shaders", Ignored))
		{
			return Folder / "share" / "drydock";
		}
	}
	return DRYDOCK_SOURCE_DIR;
}

} // namespace

void MapShippedShaders()
{
	static std::once_flag Once;
	std::call_once(Once, []
	{
		const std::filesystem::path Root = FindShippedShaders();
		const std::string Passes = (Root / "passes" / "Shaders").string();
		AddShaderDirectory("/Engine", (Root / "rdg" / "Shaders" / "Engine").string());
		AddShaderDirectory("/Engine/Private", Passes);
		AddShaderDirectory("/Project", Passes);
	});
}

} // namespace Drydock
