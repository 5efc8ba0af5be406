// Takes path names apart and puts them together by std::filesystem.
#include "Misc/Paths.h"

#include <filesystem>

namespace Files = std::filesystem;

namespace
{

Files::path ToPath(const FString& Text)
{
	return Files::path(Text.ToStdString());
}

FString ToText(const Files::path& Path)
{
	return FString(Path.generic_string());
}

} // namespace

FString FPaths::GetCleanFilename(const FString& Path)
{
	return ToText(ToPath(Path).filename());
}

FString FPaths::GetBaseFilename(const FString& Path, bool bRemovePath)
{
	const Files::path Whole = ToPath(Path);
	return ToText(bRemovePath ? Whole.stem() : Whole.parent_path() / Whole.stem());
}

FString FPaths::GetPath(const FString& Path)
{
	return ToText(ToPath(Path).parent_path());
}

FString FPaths::GetExtension(const FString& Path, bool bIncludeDot)
{
	const FString Extension = ToText(ToPath(Path).extension());
	return bIncludeDot ? Extension : Extension.Mid(1);
}

bool FPaths::IsRelative(const FString& Path)
{
	return ToPath(Path).is_relative();
}

bool FPaths::FileExists(const FString& Path)
{
	std::error_code Error;
	return Files::is_regular_file(ToPath(Path), Error);
}

bool FPaths::DirectoryExists(const FString& Path)
{
	std::error_code Error;
	return Files::is_directory(ToPath(Path), Error);
}

FString FPaths::ConvertRelativePathToFull(const FString& Path)
{
	return ToText(Files::absolute(ToPath(Path)).lexically_normal());
}

FString FPaths::ConvertRelativePathToFull(const FString& Base, const FString& Path)
{
	return ToText(Files::absolute(ToPath(Base) / ToPath(Path)).lexically_normal());
}

FString FPaths::ProjectDir()
{
	return ToText(Files::current_path()) + "/";
}

FString FPaths::ProjectPluginsDir()
{
	return ProjectDir() + "Plugins/";
}

FString FPaths::ProjectSavedDir()
{
	return ProjectDir() + "Saved/";
}
