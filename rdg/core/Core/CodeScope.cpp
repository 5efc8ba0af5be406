// Opens and closes the scopes of running code, and turns what a plugin's code throws into messages.
#include "CodeScope.h"

#include "CodeErrors.h"
#include "FaultHandlers.h"
#include "HAL/IConsoleManager.h"
#include "HAL/Watchdog.h"
#include "Misc/AssertionMacros.h"
#include "PrintText.h"
#include "RangeTools.h"

#include <cstdio>
#include <cstdlib>
#include <cxxabi.h>
#include <exception>
#include <typeinfo>

static TAutoConsoleVariable<float> CVarDrydockPluginSeconds(TEXT("r.Drydock.PluginSeconds"), 300.0f,
	TEXT("A plugin's function that has not come back for this many seconds, nor called drydock in them, ends the\n")
		TEXT("program with a message: it waits for itself, or loops without end.\n")
			TEXT(" 0: it may take as long as it likes"));

namespace Drydock
{

namespace
{

thread_local FWatchdog* GWatch = nullptr; // of the innermost scope that is a plugin's

void EndForSilence(const FCodeOwner& Owner, double Limit)
{
	if (IsEndingByFault())
	{
		return;
	}
	char Seconds[32];
	std::snprintf(Seconds, sizeof(Seconds), "%g", Limit);
	const FDiagnostic Diagnostic = {ESeverity::Error, ErrorPluginSilent,
		"the plugin has not come back for " + std::string(Seconds) +
			" s: does it wait for itself, or loop without end? (r.Drydock.PluginSeconds)",
		Owner.File, Owner.Line, 0, Owner.Describe()};
	PrintText(stderr, Diagnostic.ToString() + "\n");
	std::fflush(nullptr);
	std::_Exit(ExitPlugin);
}

/** A type's name as C++ writes it. */
std::string GetExceptionType()
{
	if (!std::current_exception())
	{
		return "an exception that is not of C++";
	}
	const std::type_info* const Type = abi::__cxa_current_exception_type();
	int Status = 0;
	char* const Name = abi::__cxa_demangle(Type->name(), nullptr, nullptr, &Status);
	const std::string Text = Name != nullptr ? Name : Type->name();
	std::free(Name);
	return Text;
}

[[noreturn]] void Throw(const FCodeOwner& Owner, int Code, const std::string& Message, EExitCode ExitCode)
{
	throw FError({ESeverity::Error, Code, Message, Owner.File, Owner.Line, 0, Owner.Describe()}, ExitCode);
}

/** A graph's message with the words before its place, unless an inner scope has put them there. */
FDiagnostic AddWords(FDiagnostic Diagnostic, const FCodeOwner& Owner)
{
	const bool bOfGraph = Diagnostic.Code >= 2000 && Diagnostic.Code < 3000;
	if (bOfGraph && Diagnostic.Where.compare(0, 7, "plugin ") != 0)
	{
		// The pass is named once.
		const std::string Pass = "pass " + Owner.Pass;
		const bool bKnown = !Owner.Pass.empty() && Diagnostic.Where.compare(0, Pass.size(), Pass) == 0;
		const std::string Words = FCodeOwner{Owner.Plugin, Owner.Callback, bKnown ? "" : Owner.Pass, {}, 0}.Describe();
		Diagnostic.Where = Words + (Diagnostic.Where.empty() ? "" : ", " + Diagnostic.Where);
		if (Diagnostic.File.empty())
		{
			Diagnostic.File = Owner.File;
			Diagnostic.Line = Owner.Line;
		}
	}
	return Diagnostic;
}

} // namespace

FCodeScope::FCodeScope(const FCodeOwner& Owner)
	: OwnerBefore(ExchangeRunningCode(&Owner))
	, WatchBefore(GWatch)
{
	EnsureFaultStack();
	if (WatchBefore != nullptr)
	{
		WatchBefore->Suspend();
	}
	const double Limit = CVarDrydockPluginSeconds.GetValueOnAnyThread();
	if (Owner.IsForeign() && Limit > 0.0)
	{
		Watch = std::make_unique<FWatchdog>(Limit, [&Owner, Limit] { EndForSilence(Owner, Limit); });
	}
	GWatch = Watch.get();
}

FCodeScope::~FCodeScope()
{
	GWatch = WatchBefore;
	Watch.reset();
	ExchangeRunningCode(OwnerBefore);
	if (WatchBefore != nullptr)
	{
		WatchBefore->Resume();
	}
}

FDiagnostic AddRunningWords(const FDiagnostic& Diagnostic)
{
	return IsForeignCodeRunning() ? AddWords(Diagnostic, *GetRunningCode()) : Diagnostic;
}

void RethrowOf(const FCodeOwner& Owner)
{
	if (!Owner.IsForeign())
	{
		throw;
	}
	try
	{
		throw;
	}
	catch (const abi::__forced_unwind&)
	{
		throw; // the end of a thread, which nobody may keep
	}
	catch (const FError& Error)
	{
		auto Diagnostics = ToVector<FDiagnostic>(
			Error.GetDiagnostics(), [&](const FDiagnostic& Diagnostic) { return AddWords(Diagnostic, Owner); });
		throw FError(std::move(Diagnostics), Error.GetExitCode());
	}
	catch (const FCheckFailure& Failure)
	{
		if (Failure.IsOfPlugin())
		{
			Throw(Owner, ErrorPluginThrew, std::string("a check of the plugin failed: ") + Failure.what(), ExitPlugin);
		}
		Throw(
			Owner, ErrorPluginCall, std::string("the plugin called what cannot be done: ") + Failure.what(), ExitUsage);
	}
	catch (const std::exception& Exception)
	{
		Throw(Owner, ErrorPluginThrew, "the plugin threw " + GetExceptionType() + ": " + Exception.what(), ExitPlugin);
	}
	catch (...)
	{
		Throw(Owner, ErrorPluginThrew, "the plugin threw " + GetExceptionType(), ExitPlugin);
	}
}

} // namespace Drydock
