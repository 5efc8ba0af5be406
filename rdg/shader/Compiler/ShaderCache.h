// Compiled shaders on disk. An entry is KEY.ID.so and KEY.ID.json (reflection, hash of the shared object); ID names the
// compiler that made it. Entries are written aside and renamed, the .json last, under a lock that other processes
// respect. They are code that is run: folders and entries that someone else could have written are not used
// (TrustedFolder.h). Two places: a read-only one that came with the installation, then the user's; in place of one that
// cannot be used or written, a third for this run alone.
#pragma once

#include "DrydockAPI.h"
#include "FileDescriptor.h"
#include "ShaderReflection.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace Drydock
{

class FTrustedFolder;
struct FFileToWrite;

/** How the process uses the user's folder. */
enum class EShaderCacheUse
{
	Usual,    // what is wrong with it is a warning
	ReadOnly, // nothing is written to it
	Required, // what is wrong with it is an error: filling it is what the process is for
};

struct FCachedShader
{
	FShaderReflection Reflection;
	/** Path, good as long as the cache is open; verified against its hash. Empty where only the reflection was asked
	 * for. */
	std::string SharedObject;
};

class DRYDOCK_API FShaderCache
{
public:
	/** Sets the use for the whole process; Usual at first. */
	static void SetUse(EShaderCacheUse Use);

	/** The user's folder (DRYDOCK_CACHE_DIR, else XDG_CACHE_HOME/drydock, else ~/.cache/drydock) and
	 * libexec/drydock/shader-cache of the installation. Each fault of theirs is reported once: DD6050, not to be
	 * trusted, and DD6051, not to be written. If the user's folder is required, its fault is thrown as an FError (exit
	 * code 3).
	 * */
	static FShaderCache Open();

	/** CompilerId empty: there is no compiler, any entry for Key will do. */
	std::optional<FCachedShader> FindKernel(const std::string& Key, const std::string& CompilerId) const;
	std::optional<FShaderReflection> FindReflection(const std::string& Key) const;

	/** Copies the file SharedObject into the cache. The entry's path, good as long as the cache is open; empty when it
	 * could not be stored. */
	std::string StoreKernel(const std::string& Key, const std::string& CompilerId, const FShaderReflection& Reflection,
		const std::string& SharedObject) const;
	void StoreReflection(const std::string& Key, const FShaderReflection& Reflection) const;

	/** Runs Work while no other process works on the same key, unless one does for too long (ShaderCacheLock.h). */
	void WithLock(const std::string& Key, const std::function<void()>& Work) const;

	/** A precompiled header, for the compiler alone; open for reading, none where it does not exist. The user's folder
	 * keeps it; where that is Required, which is to hold shaders and nothing else, it lives as long as the run.
	 * */
	FFileDescriptor OpenPrecompiled(const std::string& Name) const;
	bool TakesPrecompiled() const;
	void StorePrecompiled(const std::string& Name, const std::string& Bytes) const;

	/** A text beside the shaders in the user's folder. */
	std::optional<std::string> ReadText(const std::string& Name) const;
	void StoreText(const std::string& Name, const std::string& Text) const;

private:
	void OpenPrewarmed();
	void OpenUsers(const std::string& Path);
	bool WriteUsers(const std::vector<FFileToWrite>& Files) const;

	// Each null where there is none.
	std::shared_ptr<const FTrustedFolder> Prewarmed;
	std::shared_ptr<const FTrustedFolder> Users;
	std::shared_ptr<const FTrustedFolder> OfRun;
	bool bWritable = false; // Users
};

DRYDOCK_API std::string ReflectionToJson(const FShaderReflection& Reflection);
/** Nothing when Text is not what ReflectionToJson writes. */
DRYDOCK_API std::optional<FShaderReflection> ReflectionFromJson(const std::string& Text);

} // namespace Drydock
