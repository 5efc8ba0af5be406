// Files and folders under the engine's names. Source: engine HAL/FileManager.h, HAL/PlatformFileManager.h.
#pragma once

#include "Containers/UnrealString.h"

enum EFileWrite : uint32
{
	FILEWRITE_None = 0,
	FILEWRITE_NoFail = 1,
	FILEWRITE_NoReplaceExisting = 2,
	FILEWRITE_EvenIfReadOnly = 4,
	FILEWRITE_Append = 8,
	FILEWRITE_AllowRead = 16,
	FILEWRITE_Silent = 32
};

class DRYDOCK_API IFileManager
{
public:
	static IFileManager& Get();

	bool FileExists(const TCHAR* Path) const;
	bool DirectoryExists(const TCHAR* Path) const;
	/** bTree: with the folders above it. True where it is there afterwards. */
	bool MakeDirectory(const TCHAR* Path, bool bTree = false);
	bool CreateDirectory(const TCHAR* Path) { return MakeDirectory(Path, false); }
	bool CreateDirectoryTree(const TCHAR* Path) { return MakeDirectory(Path, true); }
	/** Bytes, or -1. */
	int64 FileSize(const TCHAR* Path) const;
};

using IPlatformFile = IFileManager;

class FPlatformFileManager
{
public:
	static FPlatformFileManager& Get()
	{
		static FPlatformFileManager Manager;
		return Manager;
	}
	IPlatformFile& GetPlatformFile() { return IFileManager::Get(); }
};
