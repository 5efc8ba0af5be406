// Whole files as text or bytes. Source: engine Misc/FileHelper.h.
#pragma once

#include "Containers/ArrayView.h"
#include "HAL/FileManager.h"

#define LINE_TERMINATOR TEXT("\n")

class DRYDOCK_API FFileHelper
{
public:
	/** Text is UTF-8 here, whatever is asked for. */
	enum class EEncodingOptions
	{
		AutoDetect,
		ForceAnsi,
		ForceUnicode,
		ForceUTF8,
		ForceUTF8WithoutBOM
	};

	/** False where it cannot be read. */
	static bool LoadFileToString(FString& Result, const TCHAR* Filename);
	static bool LoadFileToArray(TArray<uint8>& Result, const TCHAR* Filename);
	static bool SaveArrayToFile(TArrayView<const uint8> Array, const TCHAR* Filename,
		IFileManager* FileManager = &IFileManager::Get(), uint32 WriteFlags = FILEWRITE_None);
	/** WriteFlags: FILEWRITE_Append adds to what is there. False where it cannot be written. */
	static bool SaveStringToFile(const FString& Text, const TCHAR* Filename,
		EEncodingOptions EncodingOptions = EEncodingOptions::AutoDetect,
		IFileManager* FileManager = &IFileManager::Get(), uint32 WriteFlags = FILEWRITE_None);
};
