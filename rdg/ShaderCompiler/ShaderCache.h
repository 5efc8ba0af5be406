// Compiled shaders on disk. An entry is KEY.ID.so and KEY.ID.json (reflection, hash of the shared object); ID tells
// which compiler made it. Entries are written aside and renamed, the .json last, under a lock that other processes
// respect. Two places: a read-only one that came with the installation, then the user's.
#pragma once

#include "DrydockAPI.h"
#include "ShaderReflection.h"

#include <functional>
#include <optional>
#include <string>

namespace Drydock
{

struct FCachedShader
{
	FShaderReflection Reflection;
	std::string SharedObject; // path, verified against its hash; empty where only the reflection was asked for
};

class DRYDOCK_API FShaderCache
{
public:
	/** The user's folder (DRYDOCK_CACHE_DIR, else XDG_CACHE_HOME/drydock, else ~/.cache/drydock; a temporary one when
	 *  that cannot be written) and share/drydock/shader-cache of the installation. */
	static FShaderCache Open();

	FShaderCache(std::string InFolder, std::string InPrewarmed);

	/** CompilerId empty: there is no compiler, any entry for Key will do. */
	std::optional<FCachedShader> FindKernel(const std::string& Key, const std::string& CompilerId) const;
	std::optional<FShaderReflection> FindReflection(const std::string& Key) const;

	/** Moves the file SharedObject into the cache. The entry's path; empty when it could not be stored. */
	std::string StoreKernel(const std::string& Key, const std::string& CompilerId, const FShaderReflection& Reflection,
		const std::string& SharedObject) const;
	void StoreReflection(const std::string& Key, const FShaderReflection& Reflection) const;

	/** Runs Work while no other process works on the same key. */
	void WithLock(const std::string& Key, const std::function<void()>& Work) const;

	const std::string& GetFolder() const { return Folder; }

private:
	std::string Folder;
	std::string Prewarmed; // may be empty
};

DRYDOCK_API std::string ReflectionToJson(const FShaderReflection& Reflection);
/** Nothing when Text is not what ReflectionToJson writes. */
DRYDOCK_API std::optional<FShaderReflection> ReflectionFromJson(const std::string& Text);

} // namespace Drydock
