// FPaths: arithmetic of path names with forward slashes, and whether something is there. Source: engine Misc/Paths.h.
#pragma once

#include "Containers/UnrealString.h"

class DRYDOCK_API FPaths
{
public:
	/** Joins with exactly one slash between two parts; empty parts vanish. */
	template<typename... PartTypes>
	static FString Combine(const PartTypes&... Parts)
	{
		FString Result;
		((FString(Parts).IsEmpty() ? void() : void(Result /= FString(Parts))), ...);
		return Result;
	}

	/** "a/b.usf" gives "b.usf". */
	static FString GetCleanFilename(const FString& Path);
	/** "a/b.usf" gives "b", or "a/b" with the folder. */
	static FString GetBaseFilename(const FString& Path, bool bRemovePath = true);
	/** "a/b.usf" gives "a"; a name without folder gives nothing. */
	static FString GetPath(const FString& Path);
	/** "a/b.usf" gives "usf" or ".usf". */
	static FString GetExtension(const FString& Path, bool bIncludeDot = false);
	static bool IsRelative(const FString& Path);
	static bool FileExists(const FString& Path);
	static bool DirectoryExists(const FString& Path);
	/** Absolute, and without "." and "..". */
	static FString ConvertRelativePathToFull(const FString& Path);
	static FString ConvertRelativePathToFull(const FString& Base, const FString& Path);
	static void NormalizeFilename(FString& InOutPath) { InOutPath.ReplaceInline("\\", "/"); }

	/** The last "." and what follows, replaced. */
	static FString ChangeExtension(const FString& Path, const FString& Extension);
	static FString SetExtension(const FString& Path, const FString& Extension)
	{
		return ChangeExtension(Path, Extension);
	}
	static void NormalizeDirectoryName(FString& InOutPath);
	static FString GetPathLeaf(const FString& Path) { return GetCleanFilename(Path); }

	/** Folders of the project that the running plugin is part of, with a slash at the end. The plugin's folder is that
	 * of its .uplugin; the project's is the nearest above it with a .uproject, else the one that holds its folder
	 * Plugins, else the one that holds the plugin's folder. Without a plugin, where the program runs. */
	static FString ProjectDir();
	/** The folder that the plugin's folder is in: below the project's Plugins, or elsewhere. */
	static FString ProjectPluginsDir();
	static FString ProjectContentDir();
	static FString ProjectConfigDir();
	static FString ProjectSavedDir();
	static FString ProjectIntermediateDir();
	static FString ProjectLogDir();
	/** The project's Source; where there is none, the plugin's. */
	static FString GameSourceDir();
	static FString GameDir() { return ProjectDir(); }
	static FString GamePluginsDir() { return ProjectPluginsDir(); }

	/** "../../../Engine/", because there is no engine: the engine's value when it is not installed elsewhere. */
	static FString EngineDir();
	static FString EngineContentDir();
	static FString EnginePluginsDir();
};
