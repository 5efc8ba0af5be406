// Takes path names apart and puts them together by std::filesystem, and knows the running plugin's folders.
#include "Misc/Paths.h"

#include "Interfaces/IPluginManager.h"

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

struct FFolders
{
	Files::path Plugin;
	Files::path Plugins;
	Files::path Project;
};

bool HasProjectFile(const Files::path& Folder)
{
	std::error_code Error;
	for (Files::directory_iterator Entry(Folder, Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		if (Entry->path().extension() == ".uproject")
		{
			return true;
		}
	}
	return false;
}

/** Folders of the plugin whose code runs. */
FFolders FindFolders()
{
	const TSharedPtr<IPlugin> Plugin = IPluginManager::Get().FindRunningPlugin();
	if (!Plugin.IsValid())
	{
		const Files::path Here = Files::current_path();
		return {Here, Here / "Plugins", Here};
	}
	FFolders Folders;
	Folders.Plugin = Files::absolute(ToPath(Plugin->GetBaseDir())).lexically_normal();
	Folders.Plugins = Folders.Plugin.parent_path();
	Folders.Project = Folders.Plugins;
	for (Files::path Folder = Folders.Plugin; Folder.has_relative_path(); Folder = Folder.parent_path())
	{
		if (Folder.filename() == "Plugins")
		{
			Folders.Project = Folder.parent_path();
		}
	}
	for (Files::path Folder = Folders.Plugin; Folder.has_relative_path(); Folder = Folder.parent_path())
	{
		if (HasProjectFile(Folder))
		{
			Folders.Project = Folder;
			break;
		}
	}
	return Folders;
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

FString FPaths::ChangeExtension(const FString& Path, const FString& Extension)
{
	Files::path Changed = ToPath(Path);
	return ToText(Changed.replace_extension(ToPath(Extension)));
}

void FPaths::NormalizeDirectoryName(FString& InOutPath)
{
	NormalizeFilename(InOutPath);
	std::string Text = InOutPath.ToStdString();
	if (Text.size() > 1 && Text.back() == '/')
	{
		Text.pop_back();
	}
	InOutPath = FString(Text);
}

FString FPaths::ProjectDir()
{
	return ToText(FindFolders().Project) + "/";
}

FString FPaths::ProjectPluginsDir()
{
	return ToText(FindFolders().Plugins) + "/";
}

FString FPaths::ProjectContentDir()
{
	return ProjectDir() + "Content/";
}

FString FPaths::ProjectConfigDir()
{
	return ProjectDir() + "Config/";
}

FString FPaths::ProjectSavedDir()
{
	return ProjectDir() + "Saved/";
}

FString FPaths::ProjectIntermediateDir()
{
	return ProjectDir() + "Intermediate/";
}

FString FPaths::ProjectLogDir()
{
	return ProjectSavedDir() + "Logs/";
}

FString FPaths::GameSourceDir()
{
	const FFolders Folders = FindFolders();
	const Files::path OfProject = Folders.Project / "Source";
	std::error_code Error;
	return ToText(Files::is_directory(OfProject, Error) ? OfProject : Folders.Plugin / "Source") + "/";
}

FString FPaths::EngineDir()
{
	return TEXT("../../../Engine/");
}

FString FPaths::EngineContentDir()
{
	return EngineDir() + "Content/";
}

FString FPaths::EnginePluginsDir()
{
	return EngineDir() + "Plugins/";
}
