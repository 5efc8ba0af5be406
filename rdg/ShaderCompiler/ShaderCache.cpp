// Finds, checks, writes and locks the entries of the shader cache.
#include "ShaderCache.h"

#include "ContentHash.h"
#include "InstallPaths.h"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

std::string ReadFile(const fs::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string((std::istreambuf_iterator<char>(Stream)), {});
}

/** Writes aside and renames, so that a reader sees the old file or the new one. */
bool WriteFile(const fs::path& Path, const std::string& Bytes)
{
	const fs::path Aside = Path.string() + "." + std::to_string(getpid()) + ".tmp";
	{
		std::ofstream Stream(Aside, std::ios::binary | std::ios::trunc);
		Stream << Bytes;
		Stream.flush();
		if (!Stream)
		{
			std::error_code Error;
			fs::remove(Aside, Error);
			return false;
		}
	}
	std::error_code Error;
	fs::rename(Aside, Path, Error);
	return !Error;
}

bool IsWritable(const std::string& Folder)
{
	std::error_code Error;
	fs::create_directories(Folder, Error);
	return access(Folder.c_str(), W_OK | X_OK) == 0;
}

std::string ChooseFolder()
{
	const auto Variable = [](const char* Name)
	{
		const char* Value = std::getenv(Name);
		return std::string(Value ? Value : "");
	};
	const std::string Candidates[] = {
		Variable("DRYDOCK_CACHE_DIR"),
		Variable("XDG_CACHE_HOME").empty() ? std::string() : Variable("XDG_CACHE_HOME") + "/drydock",
		Variable("HOME").empty() ? std::string() : Variable("HOME") + "/.cache/drydock",
	};
	for (const std::string& Candidate : Candidates)
	{
		if (!Candidate.empty())
		{
			// The first one that is named is the one; a folder that cannot be written must not scatter entries
			// elsewhere.
			if (IsWritable(Candidate))
			{
				return Candidate;
			}
			break;
		}
	}
	const std::string Temporary = (fs::temp_directory_path() / ("drydock-" + std::to_string(getuid()))).string();
	IsWritable(Temporary);
	return Temporary;
}

// First line of an entry's .json: the hash of the shared object (or "-"). The rest is the reflection.
std::optional<FCachedShader> ReadEntry(const fs::path& Json)
{
	const std::string Text = ReadFile(Json);
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
		fs::path SharedObject = Json;
		SharedObject.replace_extension(".so");
		if (HashBytes(ReadFile(SharedObject)) != Hash)
		{
			return {};
		}
		Result.SharedObject = SharedObject.string();
	}
	return Result;
}

std::optional<FCachedShader> FindAny(const std::string& Folder, const std::string& Key)
{
	std::error_code Error;
	for (fs::directory_iterator It(fs::path(Folder) / Key.substr(0, 2), Error), End; !Error && It != End;
		 It.increment(Error))
	{
		const std::string Name = It->path().filename().string();
		if (Name.rfind(Key + ".", 0) == 0 && It->path().extension() == ".json" && Name != Key + ".reflection.json")
		{
			if (std::optional<FCachedShader> Found = ReadEntry(It->path()))
			{
				return Found;
			}
		}
	}
	return {};
}

fs::path EntryPath(const std::string& Folder, const std::string& Key, const std::string& Id)
{
	return fs::path(Folder) / Key.substr(0, 2) / (Key + "." + Id + ".json");
}

} // namespace

FShaderCache::FShaderCache(std::string InFolder, std::string InPrewarmed)
	: Folder(std::move(InFolder))
	, Prewarmed(std::move(InPrewarmed))
{
}

FShaderCache FShaderCache::Open()
{
	return FShaderCache(ChooseFolder(), FindInstalled("share/drydock/shader-cache"));
}

std::optional<FCachedShader> FShaderCache::FindKernel(const std::string& Key, const std::string& CompilerId) const
{
	if (!Prewarmed.empty())
	{
		if (std::optional<FCachedShader> Found = FindAny(Prewarmed, Key))
		{
			return Found;
		}
	}
	return CompilerId.empty() ? FindAny(Folder, Key) : ReadEntry(EntryPath(Folder, Key, CompilerId));
}

std::optional<FShaderReflection> FShaderCache::FindReflection(const std::string& Key) const
{
	for (const std::string& Place : {Prewarmed, Folder})
	{
		const std::optional<FCachedShader> Found =
			Place.empty() ? std::nullopt : ReadEntry(EntryPath(Place, Key, "reflection"));
		if (Found)
		{
			return Found->Reflection;
		}
	}
	return {};
}

std::string FShaderCache::StoreKernel(const std::string& Key, const std::string& CompilerId,
	const FShaderReflection& Reflection, const std::string& SharedObject) const
{
	const fs::path Json = EntryPath(Folder, Key, CompilerId);
	fs::path Target = Json;
	Target.replace_extension(".so");
	std::error_code Error;
	fs::create_directories(Json.parent_path(), Error);
	const std::string Bytes = ReadFile(SharedObject);
	if (!WriteFile(Target, Bytes) || !WriteFile(Json, HashBytes(Bytes) + "\n" + ReflectionToJson(Reflection)))
	{
		return {};
	}
	return Target.string();
}

void FShaderCache::StoreReflection(const std::string& Key, const FShaderReflection& Reflection) const
{
	const fs::path Json = EntryPath(Folder, Key, "reflection");
	std::error_code Error;
	fs::create_directories(Json.parent_path(), Error);
	WriteFile(Json, "-\n" + ReflectionToJson(Reflection)); // a cache that cannot be written is a slow one, no error
}

void FShaderCache::WithLock(const std::string& Key, const std::function<void()>& Work) const
{
	const fs::path Locks = fs::path(Folder) / "locks";
	std::error_code Error;
	fs::create_directories(Locks, Error);
	// A few locks for all keys: keys that share one wait for each other, which costs time only.
	const int File = open((Locks / Key.substr(0, 2)).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
	if (File >= 0)
	{
		flock(File, LOCK_EX);
	}
	try
	{
		Work();
	}
	catch (...)
	{
		if (File >= 0)
		{
			close(File);
		}
		throw;
	}
	if (File >= 0)
	{
		close(File);
	}
}

} // namespace Drydock
