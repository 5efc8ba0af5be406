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

	/** Where the program runs: there is no project folder. */
	static FString ProjectDir();
	static FString ProjectPluginsDir();
	static FString ProjectSavedDir();
};
