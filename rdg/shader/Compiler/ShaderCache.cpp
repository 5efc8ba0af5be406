// Chooses the folders of the shader cache; finds, checks and writes its entries.
#include "ShaderCache.h"

#include "ContentHash.h"
#include "Diagnostics.h"
#include "InstallPaths.h"
#include "PrintText.h"
#include "ShaderCacheLock.h"
#include "TemporaryFolder.h"
#include "TrustedFolder.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <mutex>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

using FFolder = std::shared_ptr<const FTrustedFolder>;

constexpr uid_t RootUser = 0;
constexpr const char* Instead = "; this run keeps what it compiles to itself";

std::atomic<EShaderCacheUse> GUse = EShaderCacheUse::Usual;

/** Whether it is the first call with this text in the process. */
bool IsFirst(const std::string& Text)
{
	static std::mutex Mutex;
	static std::set<std::string> Known;
	const std::lock_guard Lock(Mutex);
	return Known.insert(Text).second;
}

void WarnOnce(const FDiagnostic& Diagnostic)
{
	if (const std::string Text = Diagnostic.ToString(); IsFirst(Text))
	{
		PrintText(stderr, Text + "\n");
	}
}

/** Reports a fault of the user's folder. */
void Report(FDiagnostic Diagnostic)
{
	if (GUse == EShaderCacheUse::Required)
	{
		Diagnostic.Severity = ESeverity::Error;
		throw FError(Diagnostic, ExitFiles);
	}
	Diagnostic.Message += Instead;
	WarnOnce(Diagnostic);
}

FDiagnostic MakeDistrust(const std::string& Path, const std::string& Fault)
{
	return {ESeverity::Warning, 6050,
		"the shader cache is code that is run, and this " + Fault +
			": it is not used (wanted: the user's own, no link, writable by no one else)",
		Path, 0, 0, {}};
}

FDiagnostic MakeUnwritten(const std::string& Path, const std::string& Why)
{
	return {ESeverity::Warning, 6051, "the shader cache cannot be written: " + Why, Path, 0, 0, {}};
}

std::string GetVariable(const char* Name)
{
	const char* const Value = std::getenv(Name);
	return Value ? Value : "";
}

/** The first that is named is the one; a folder that cannot be used must not scatter entries elsewhere. */
std::string ChooseFolder()
{
	if (const std::string Chosen = GetVariable("DRYDOCK_CACHE_DIR"); !Chosen.empty())
	{
		return Chosen;
	}
	if (const std::string Caches = GetVariable("XDG_CACHE_HOME"); !Caches.empty())
	{
		return Caches + "/drydock";
	}
	const std::string Home = GetVariable("HOME");
	return Home.empty() ? Home : Home + "/.cache/drydock";
}

/** Takes the place of a cache that cannot be written, until the process ends. */
struct FFolderOfRun
{
	FTemporaryFolder Temporary;
	FFolder Folder = [this]
	{
		const std::string Path = Temporary.Reserve("cache");
		FTrustedFolder::Make(Path);
		return std::make_shared<const FTrustedFolder>(Path, std::vector<uid_t>{geteuid()});
	}();
};

/** Null where there is none and none is to be made. Throws FError where none can be made. */
FFolder FindFolderOfRun(bool bMake)
{
	static std::mutex Mutex;
	static std::unique_ptr<FFolderOfRun> Made;
	const std::lock_guard Lock(Mutex);
	if (!Made && bMake)
	{
		Made = std::make_unique<FFolderOfRun>();
	}
	return Made ? Made->Folder : nullptr;
}

std::string GetEntryName(const std::string& Key, const std::string& Id, const char* Extension)
{
	return Key.substr(0, 2) + "/" + Key + "." + Id + Extension;
}

/** All bytes of a file, or nothing where it cannot be read or trusted. */
std::optional<std::string> ReadChecked(const FTrustedFolder& Folder, const std::string& Name)
{
	const FTrustedFile File = Folder.Open(Name);
	if (File.Trust == ETrust::Foreign && IsFirst("an entry that is not trusted"))
	{
		WarnOnce(MakeDistrust(Folder.GetPath() + "/" + Name, File.Fault));
	}
	if (File.Trust != ETrust::Trusted)
	{
		return {};
	}
	int Error = 0;
	const std::string Bytes = ReadToEnd(File.File, Error);
	return Error == 0 ? std::optional(Bytes) : std::nullopt;
}

// First line of an entry's .json: the hash of the shared object (or "-"). The rest is the reflection.
std::optional<FCachedShader> ReadEntry(const FTrustedFolder& Folder, const std::string& Key, const std::string& Id)
{
	const std::string Text = ReadChecked(Folder, GetEntryName(Key, Id, ".json")).value_or("");
	const size_t LineEnd = Text.find('\n');
	if (LineEnd == std::string::npos)
	{
		return {};
	}
	const std::optional<FShaderReflection> Reflection = ReflectionFromJson(Text.substr(LineEnd + 1));
	if (!Reflection)
	{
		return {};
	}
	FCachedShader Result{*Reflection, {}};
	const std::string Hash = Text.substr(0, LineEnd);
	if (Hash != "-")
	{
		// dlopen of a damaged file can end the process, so the bytes are checked first.
		const std::string Name = GetEntryName(Key, Id, ".so");
		const std::optional<std::string> Bytes = ReadChecked(Folder, Name);
		if (!Bytes || HashBytes(*Bytes) != Hash)
		{
			return {};
		}
		Result.SharedObject = Folder.GetLoadPath(Name);
	}
	return Result;
}

std::optional<FCachedShader> FindAny(const FTrustedFolder& Folder, const std::string& Key)
{
	const std::string Begin = Key + ".";
	const std::string End = ".json";
	for (const std::string& Name : Folder.List(Key.substr(0, 2)))
	{
		if (Name.size() <= Begin.size() + End.size() || !Name.starts_with(Begin) || !Name.ends_with(End))
		{
			continue;
		}
		const std::string Id = Name.substr(Begin.size(), Name.size() - Begin.size() - End.size());
		if (std::optional<FCachedShader> Found = Id == "reflection" ? std::nullopt : ReadEntry(Folder, Key, Id))
		{
			return Found;
		}
	}
	return {};
}

std::optional<FCachedShader> FindIn(const FFolder& Folder, const std::string& Key, const std::string& CompilerId)
{
	if (!Folder)
	{
		return {};
	}
	return CompilerId.empty() ? FindAny(*Folder, Key) : ReadEntry(*Folder, Key, CompilerId);
}

} // namespace

void FShaderCache::SetUse(EShaderCacheUse Use)
{
	GUse = Use;
}

FShaderCache FShaderCache::Open()
{
	if (IsFirst("temporary leftovers"))
	{
		RemoveTemporaryFolders(GetTemporaryParent());
	}
	FShaderCache Cache;
	Cache.OpenPrewarmed();
	const std::string Path = ChooseFolder();
	if (Path.empty())
	{
		Report(MakeUnwritten("", "none of DRYDOCK_CACHE_DIR, XDG_CACHE_HOME and HOME is set"));
	}
	else
	{
		Cache.OpenUsers(Path);
	}
	Cache.OfRun = FindFolderOfRun(false);
	return Cache;
}

void FShaderCache::OpenPrewarmed()
{
	const std::string Path = FindInstalled("libexec/drydock/shader-cache");
	struct stat Library;
	if (Path.empty() || stat(GetLibraryPath().c_str(), &Library) != 0)
	{
		return;
	}
	// Whoever owns the library has his code run already.
	const auto Folder =
		std::make_shared<const FTrustedFolder>(Path, std::vector<uid_t>{geteuid(), RootUser, Library.st_uid});
	if (Folder->GetTrust() == ETrust::Foreign)
	{
		WarnOnce(MakeDistrust(Path, Folder->GetFault()));
	}
	Prewarmed = Folder->GetTrust() == ETrust::Trusted ? Folder : nullptr;
}

void FShaderCache::OpenUsers(const std::string& Path)
{
	const bool bReadOnly = GUse == EShaderCacheUse::ReadOnly;
	const int MakeError = bReadOnly ? 0 : FTrustedFolder::Make(Path);
	const auto Folder = std::make_shared<const FTrustedFolder>(Path, std::vector<uid_t>{geteuid(), RootUser});
	if (Folder->GetTrust() == ETrust::Foreign)
	{
		Report(MakeDistrust(Path, Folder->GetFault()));
		return;
	}
	Users = Folder->GetTrust() == ETrust::Trusted ? Folder : nullptr;
	const int Error = MakeError != 0 ? MakeError : Users ? Users->FindWriteError() : 0;
	bWritable = Users && Error == 0 && !bReadOnly;
	if (!bWritable && !bReadOnly)
	{
		Report(MakeUnwritten(Path, Error != 0 ? DescribeSystemError(Error) : Folder->GetFault()));
	}
	if (bWritable && IsFirst("leftovers of " + Path))
	{
		RemoveTemporaryFolders(Path);
	}
}

std::optional<FCachedShader> FShaderCache::FindKernel(const std::string& Key, const std::string& CompilerId) const
{
	std::optional<FCachedShader> Found = FindIn(Prewarmed, Key, "");
	Found = Found ? Found : FindIn(Users, Key, CompilerId);
	return Found ? Found : FindIn(OfRun, Key, CompilerId);
}

std::optional<FShaderReflection> FShaderCache::FindReflection(const std::string& Key) const
{
	for (const FFolder& Place : {Prewarmed, Users})
	{
		const std::optional<FCachedShader> Found = FindIn(Place, Key, "reflection");
		if (Found)
		{
			return Found->Reflection;
		}
	}
	return {};
}

bool FShaderCache::WriteUsers(const std::vector<FFileToWrite>& Files) const
{
	const int Error = bWritable ? Users->Write(Files) : EROFS;
	if (bWritable && Error != 0)
	{
		Report(MakeUnwritten(Users->GetPath(), DescribeSystemError(Error)));
	}
	return Error == 0;
}

std::string FShaderCache::StoreKernel(const std::string& Key, const std::string& CompilerId,
	const FShaderReflection& Reflection, const std::string& SharedObject) const
{
	int Error = 0;
	const FFileDescriptor Compiled(open(SharedObject.c_str(), O_RDONLY | O_CLOEXEC));
	const std::string Bytes = ReadToEnd(Compiled, Error);
	const std::string Name = GetEntryName(Key, CompilerId, ".so");
	const std::vector<FFileToWrite> Files = {{Name, Bytes},
		{GetEntryName(Key, CompilerId, ".json"), HashBytes(Bytes) + "\n" + ReflectionToJson(Reflection)}};
	if (Error != 0)
	{
		return {};
	}
	if (WriteUsers(Files))
	{
		return Users->GetLoadPath(Name);
	}
	try
	{
		const FFolder Folder = FindFolderOfRun(true);
		return Folder->Write(Files) == 0 ? Folder->GetLoadPath(Name) : std::string();
	}
	catch (const FError&)
	{
		return {}; // it runs from where it was compiled
	}
}

void FShaderCache::StoreReflection(const std::string& Key, const FShaderReflection& Reflection) const
{
	WriteUsers({{GetEntryName(Key, "reflection", ".json"), "-\n" + ReflectionToJson(Reflection)}});
}

void FShaderCache::WithLock(const std::string& Key, const std::function<void()>& Work) const
{
	// A few locks for all keys: keys that share one wait for each other, which costs time only.
	std::optional<FShaderCacheLock> Lock;
	if (bWritable)
	{
		Lock.emplace(*Users, Key.substr(0, 2));
	}
	Work();
}

FFileDescriptor FShaderCache::OpenPrecompiled(const std::string& Name) const
{
	const FFolder& Place = GUse == EShaderCacheUse::Required ? OfRun : Users;
	return Place ? Place->Open(Name).File : FFileDescriptor();
}

bool FShaderCache::TakesPrecompiled() const
{
	return bWritable;
}

void FShaderCache::StorePrecompiled(const std::string& Name, const std::string& Bytes) const
{
	(GUse == EShaderCacheUse::Required ? FindFolderOfRun(true) : Users)->Write({{Name, Bytes}});
}

std::optional<std::string> FShaderCache::ReadText(const std::string& Name) const
{
	return Users ? ReadChecked(*Users, Name) : std::nullopt;
}

void FShaderCache::StoreText(const std::string& Name, const std::string& Text) const
{
	WriteUsers({{Name, Text}});
}

} // namespace Drydock
