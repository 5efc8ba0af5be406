// Maps the folders of shader files, and holds the settings that a shader is compiled with. Source: engine ShaderCore.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIDefinitions.h"

#include <string>
#include <utility>
#include <vector>

/** Maps a virtual directory ("/MyPlugin") to one on disk. Any time before the first use of a shader below it; a later
 *  mapping of the same directory wins. drydock maps /Engine and /Project itself. */
DRYDOCK_API void AddShaderSourceDirectoryMapping(
	const FString& VirtualShaderDirectory, const FString& RealShaderDirectory);

/** The mappings of AddShaderSourceDirectoryMapping, and drydock's own: virtual to real directories. */
DRYDOCK_API const TMap<FString, FString>& AllShaderSourceDirectoryMappings();

/** Forgets those that were added; drydock's own stay. */
DRYDOCK_API void ResetAllShaderSourceDirectoryMappings();

/** `SET_SHADER_DEFINE(OutEnvironment, MY_DEFINE, 1)`. */
#define SET_SHADER_DEFINE(Environment, Name, Value) (Environment).SetDefine(TEXT(#Name), Value)

/** Accepted and ignored. */
enum ECompilerFlags
{
	CFLAG_PreferFlowControl = 0,
	CFLAG_Debug,
	CFLAG_AvoidFlowControl,
	CFLAG_OnChip,
	CFLAG_StandardOptimization,
	CFLAG_AllowTypedUAVLoads,
	CFLAG_WaveOperations,
	CFLAG_Wave32,
	CFLAG_AllowRealTypes,
	CFLAG_InlineRayTracing,
	CFLAG_Max,
};

/** The defines of one permutation, in the order of their first definition; a later SetDefine of a name replaces its
 * value. */
class FShaderCompilerEnvironment
{
public:
	DRYDOCK_API void SetDefine(const TCHAR* Name, const TCHAR* Value);
	void SetDefine(const TCHAR* Name, const FString& Value) { SetDefine(Name, *Value); }
	/** true is 1, false is 0. */
	DRYDOCK_API void SetDefine(const TCHAR* Name, bool Value);
	DRYDOCK_API void SetDefine(const TCHAR* Name, int32 Value);
	DRYDOCK_API void SetDefine(const TCHAR* Name, uint32 Value);
	/** The shortest text that reads back as the same float, always with a decimal point or an exponent. */
	DRYDOCK_API void SetDefine(const TCHAR* Name, float Value);
	void SetDefine(const TCHAR* Name, double Value) { SetDefine(Name, static_cast<float>(Value)); }

	const std::vector<std::pair<std::string, std::string>>& GetDefines() const { return Defines; }

	/** Shaders add ECompilerFlags here; a CPU has no use for them. */
	TArray<uint32> CompilerFlags;

private:
	std::vector<std::pair<std::string, std::string>> Defines;
};

namespace Drydock
{

/** Maps /Engine and /Project to the shaders that ship with drydock, once: from the source tree where the library was
 *  built there, else beside the installed library. Called before every compilation; mappings of users win. */
DRYDOCK_API void MapShippedShaders();

/** Maps a plugin's folder of shaders in its place: a note tells its author where the plugin does not do so itself. */
DRYDOCK_API void MapPluginShaders(const std::string& VirtualDirectory, const std::string& RealDirectory);

} // namespace Drydock
