// Describes whose code runs on a thread, in words that are prepared beforehand, for messages and for signal handlers.
// CodeScope.h says it.
#pragma once

#include "CoreTypes.h"
#include "Templates/UnrealTemplate.h"

#include <string>

namespace Drydock
{

/** The owner of running code, and the place that called it. */
struct FCodeOwner
{
	std::string Plugin = {};   // file name of the shared object; empty: drydock's own, or that of a program around it
	std::string Callback = {}; // "SetupView of extension FTint", "StartupModule of module Tint", "shader FTintPS"
	std::string Pass = {};     // empty: none
	std::string File = {};     // of the pass's AddPass; empty: unknown
	int Line = 0;

	bool IsForeign() const { return !Plugin.empty(); }
	/** "plugin libTint.so, SetupView of extension FTint, pass Tint" */
	DRYDOCK_API std::string Describe() const;
};

/** The code of the innermost scope of this thread; null: none. */
DRYDOCK_API const FCodeOwner* GetRunningCode();

/** A plugin's code runs on this thread. */
DRYDOCK_API bool IsForeignCodeRunning();

/** Code of whoever runs now: what a plugin registers is the plugin's. */
DRYDOCK_API FCodeOwner MakeCodeOwner(const std::string& Callback);

/** Sets what GetRunningCode returns, and the words; returns what it was. For FCodeScope. */
DRYDOCK_API const FCodeOwner* ExchangeRunningCode(const FCodeOwner* Owner);

/** The text that a signal handler may read: Describe() of the running code, outside any stack. */
struct FRunningWords
{
	bool bForeign = false;
	char Text[512] = "";
};
DRYDOCK_API const FRunningWords& GetRunningWords();

/** During its scope this thread works for another thread, whose code and words (GetRunningCode, GetRunningWords) it
 * takes over. They must outlive it. */
class DRYDOCK_API FBorrowedCode : private FNoncopyable
{
public:
	FBorrowedCode(const FCodeOwner* Owner, const FRunningWords& Words);
	~FBorrowedCode();

private:
	const FCodeOwner* OwnerBefore;
	FRunningWords WordsBefore;
};

/** Notes where a plugin lies in memory, by the address of anything in it; an unloaded one is forgotten. */
DRYDOCK_API void NotePluginCode(const std::string& Plugin, const void* Anything);
DRYDOCK_API void ForgetPluginCode(const std::string& Plugin);

/** The plugin that Address lies in, and how far from its start; null: none. For handlers of signals, too. */
DRYDOCK_API const char* FindPluginCode(const void* Address, uint64& OutOffset);

} // namespace Drydock
