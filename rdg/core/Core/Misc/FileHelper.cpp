// Reads and writes files as plugins ask for it.
#include "Misc/FileHelper.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Files = std::filesystem;

IFileManager& IFileManager::Get()
{
	static IFileManager Manager;
	return Manager;
}

bool IFileManager::FileExists(const TCHAR* Path) const
{
	std::error_code Error;
	return Files::is_regular_file(Path, Error);
}

bool IFileManager::DirectoryExists(const TCHAR* Path) const
{
	std::error_code Error;
	return Files::is_directory(Path, Error);
}

bool IFileManager::MakeDirectory(const TCHAR* Path, bool bTree)
{
	std::error_code Error;
	bTree ? Files::create_directories(Path, Error) : Files::create_directory(Path, Error);
	return DirectoryExists(Path);
}

int64 IFileManager::FileSize(const TCHAR* Path) const
{
	std::error_code Error;
	const auto Size = Files::file_size(Path, Error);
	return Error ? -1 : static_cast<int64>(Size);
}

bool FFileHelper::LoadFileToString(FString& Result, const TCHAR* Filename)
{
	std::ifstream File(Filename, std::ios::binary);
	std::ostringstream Text;
	if (!File || !(Text << File.rdbuf()))
	{
		return false;
	}
	Result = FString(Text.str());
	return true;
}

bool FFileHelper::SaveArrayToFile(
	TArrayView<const uint8> Array, const TCHAR* Filename, IFileManager*, uint32 WriteFlags)
{
	const auto Mode = (WriteFlags & FILEWRITE_Append) != 0 ? std::ios::app : std::ios::trunc;
	std::ofstream File(Filename, std::ios::binary | std::ios::out | Mode);
	File.write(reinterpret_cast<const char*>(Array.GetData()), Array.Num());
	return static_cast<bool>(File.flush());
}

bool FFileHelper::SaveStringToFile(
	const FString& Text, const TCHAR* Filename, EEncodingOptions, IFileManager* FileManager, uint32 WriteFlags)
{
	const std::string Bytes = Text.ToStdString();
	return SaveArrayToFile(
		TArrayView<const uint8>(reinterpret_cast<const uint8*>(Bytes.data()), static_cast<int32>(Bytes.size())),
		Filename, FileManager, WriteFlags);
}

bool FFileHelper::LoadFileToArray(TArray<uint8>& Result, const TCHAR* Filename)
{
	FString Text;
	if (!LoadFileToString(Text, Filename))
	{
		return false;
	}
	Result.Reset();
	Result.Append(reinterpret_cast<const uint8*>(*Text), Text.Len());
	return true;
}
