// The one initializer that the constructors of objects are given, and the messages about assets that code asks for.
#include "UObject/Object.h"

#include "Logging/LogMacros.h"

#include <mutex>
#include <set>
#include <string>

const FObjectInitializer& FObjectInitializer::Get()
{
	static const FObjectInitializer Initializer;
	return Initializer;
}

void Drydock::WarnOfMissingAsset(const TCHAR* Path)
{
	static std::mutex Mutex;
	static std::set<std::string> Named;
	const std::lock_guard Lock(Mutex);
	if (Named.insert(Path != nullptr ? Path : "").second)
	{
		UE_LOG(LogCore, Warning, "Failed to find object '%s': no asset is loaded here, and the answer is null",
			Path != nullptr ? Path : "");
	}
}
