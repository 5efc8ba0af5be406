// Tells a crash in one line. Everything that a handler of signals calls here is safe there: no memory is taken, no
// lock, and the words are ready before anything can happen.
#include "FaultHandlers.h"

#include "CodeErrors.h"
#include "CrashPlace.h"
#include "Diagnostics.h"
#include "RunningCode.h"
#include "Templates/UnrealTemplate.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <ucontext.h>
#include <unistd.h>

#if defined(__has_feature)
#define DRYDOCK_HAS_FEATURE(Feature) __has_feature(Feature)
#else
#define DRYDOCK_HAS_FEATURE(Feature) 0
#endif

namespace Drydock
{

namespace
{

/** Sanitizers have handlers of their own, which say more. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || DRYDOCK_HAS_FEATURE(address_sanitizer) || \
	DRYDOCK_HAS_FEATURE(thread_sanitizer)
constexpr bool bHasSanitizer = true;
#else
constexpr bool bHasSanitizer = false;
#endif
#undef DRYDOCK_HAS_FEATURE

constexpr int Signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT};

bool GInstalled = false;
std::atomic<long> GEndingThread{0}; // that tells its fault; 0: none

/** A line of text without memory of its own. */
class FLine
{
public:
	FLine& Add(const char* Text)
	{
		const size_t Length = std::min(std::strlen(Text), sizeof(Buffer) - Size);
		std::memcpy(Buffer + Size, Text, Length);
		Size += Length;
		return *this;
	}

	FLine& AddNumber(uint64 Value, unsigned Base)
	{
		char Digits[24];
		char* Begin = Digits + sizeof(Digits) - 1;
		*Begin = '\0';
		do
		{
			*--Begin = "0123456789abcdef"[Value % Base];
			Value /= Base;
		} while (Value > 0);
		return Add(Base == 16 ? "0x" : "").Add(Begin);
	}

	void Write() const
	{
		for (size_t Written = 0; Written < Size;)
		{
			const ssize_t Step = write(STDERR_FILENO, Buffer + Written, Size - Written);
			if (Step <= 0)
			{
				return;
			}
			Written += size_t(Step);
		}
	}

private:
	char Buffer[2048];
	size_t Size = 0;
};

const char* GetSignalText(int Signal)
{
	return Signal == SIGSEGV   ? "segmentation fault (SIGSEGV)"
		   : Signal == SIGBUS  ? "bus error (SIGBUS)"
		   : Signal == SIGFPE  ? "arithmetic fault (SIGFPE)"
		   : Signal == SIGILL  ? "illegal instruction (SIGILL)"
		   : Signal == SIGTRAP ? "breakpoint (SIGTRAP)"
							   : "abort (SIGABRT)";
}

const void* GetInstruction(const void* Context)
{
	const mcontext_t& Machine = static_cast<const ucontext_t*>(Context)->uc_mcontext;
#if defined(__x86_64__)
	return reinterpret_cast<const void*>(Machine.gregs[REG_RIP]);
#elif defined(__aarch64__)
	return reinterpret_cast<const void*>(Machine.pc);
#else
	(void)Machine;
	return nullptr;
#endif
}

/** Whether a fault at Address is that of a stack without room: such a one lies beside the stack pointer. */
bool IsStackOverflow(int Signal, const void* Address, const void* Context)
{
	const mcontext_t& Machine = static_cast<const ucontext_t*>(Context)->uc_mcontext;
#if defined(__x86_64__)
	const auto Stack = uintptr_t(Machine.gregs[REG_RSP]);
#elif defined(__aarch64__)
	const auto Stack = uintptr_t(Machine.sp);
#else
	const uintptr_t Stack = 0;
	(void)Machine;
#endif
	constexpr uintptr_t Near = 1 << 16;
	const auto Fault = reinterpret_cast<uintptr_t>(Address);
	return (Signal == SIGSEGV || Signal == SIGBUS) && (Fault > Stack ? Fault - Stack : Stack - Fault) < Near;
}

/** Whose fault it is, by what runs on this thread and by where the instruction lies. */
struct FBlame
{
	bool bForeign = false;
	const char* Plugin = nullptr; // that the instruction lies in
	uint64 Offset = 0;
	FCrashPlace Place;
};

FBlame GBlame;

void FindBlame(const void* Instruction)
{
	GBlame.Plugin = FindPluginCode(Instruction, GBlame.Offset);
	GBlame.bForeign = GetRunningWords().bForeign || GBlame.Plugin != nullptr;
}

/** One line: whose code, what happened, in which instruction. */
void WriteFault(const FLine& (*AddWhat)(FLine&, const void*), const void* What)
{
	const FRunningWords& Words = GetRunningWords();
	const FCrashPlace& Place = GBlame.Place;
	const bool bPluginAlone = GBlame.bForeign && !Place.bOfDrydock;
	FLine Line;
	Line.Add(isatty(STDERR_FILENO) ? "\n" : ""); // a progress bar may stand in the line
	if (bPluginAlone)
	{
		Line.Add("error DD").AddNumber(ErrorPluginCrashed, 10).Add(" at ");
		if (!Words.bForeign)
		{
			Line.Add("plugin ").Add(GBlame.Plugin).Add(Words.Text[0] != '\0' ? ", in " : "");
		}
		Line.Add(Words.Text).Add(": the plugin ");
	}
	else
	{
		Line.Add("drydock crashed in ").Add(Words.Text[0] != '\0' ? Words.Text : "a thread of its own").Add(": it ");
	}
	AddWhat(Line, What);
	const char* const Drydock = Place.Drydock;
	Line.Add(Drydock[0] != '\0' ? " in " : "").Add(Drydock);
	const char* const CalledAt = Drydock[0] != '\0' || !bPluginAlone ? ", called at " : " in ";
	Line.Add(Place.Plugin[0] != '\0' ? CalledAt : "").Add(Place.Plugin);
	if (const char* const Library = GBlame.Plugin != nullptr ? GBlame.Plugin : Place.Library)
	{
		const uint64 Offset = GBlame.Plugin != nullptr ? GBlame.Offset : Place.Offset;
		Line.Add(" (").Add(Library).Add("+").AddNumber(Offset, 16).Add(")");
	}
	const char* const OfDrydock =
		GBlame.bForeign ? "; drydock's code is at fault, or what the plugin gave it\n" : "; this is drydock's fault\n";
	Line.Add(bPluginAlone ? "\n" : OfDrydock).Write();
}

int GetExitCode()
{
	return GBlame.bForeign && !GBlame.Place.bOfDrydock ? ExitPlugin : ExitInternal;
}

/** True in a child that is to die of the signal for the sake of its core file, once per fault; the parent has waited
 * for it. */
bool IsChildForCore(int Signal)
{
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
	rlimit Limit;
	if (getrlimit(RLIMIT_CORE, &Limit) != 0 || Limit.rlim_cur == 0)
	{
		return false;
	}
	const pid_t Child = _Fork();
	if (Child == 0)
	{
		signal(Signal, SIG_DFL);
		return true;
	}
	int Status = 0;
	while (Child > 0 && waitpid(Child, &Status, 0) < 0 && errno == EINTR)
	{
	}
#else
	(void)Signal;
#endif
	return false;
}

struct FSignal
{
	int Number;
	const siginfo_t* Info;
	const void* Context;
};

const FLine& AddSignal(FLine& Line, const void* Data)
{
	const FSignal& Signal = *static_cast<const FSignal*>(Data);
	if (Signal.Number == SIGABRT)
	{
		return Line.Add("called abort");
	}
	if (IsStackOverflow(Signal.Number, Signal.Info->si_addr, Signal.Context))
	{
		return Line.Add("overflowed its stack");
	}
	Line.Add("crashed: ").Add(GetSignalText(Signal.Number));
	const bool bHasAddress = (Signal.Number == SIGSEGV || Signal.Number == SIGBUS) && Signal.Info->si_code > 0 &&
							 Signal.Info->si_code != SI_KERNEL;
	return bHasAddress ? Line.Add(" at address ").AddNumber(uint64(Signal.Info->si_addr), 16) : Line;
}

void OnSignal(int Number, siginfo_t* Info, void* Context)
{
	if (Info->si_code <= 0 && Info->si_pid != getpid())
	{
		// Nobody's fault: another process has sent it, and wants what it always does.
		signal(Number, SIG_DFL);
		kill(getpid(), Number);
		return;
	}
	static std::atomic<bool> bTold{false};
	static FSignal First;
	const long Thread = syscall(SYS_gettid);
	long Other = 0;
	if (!GEndingThread.compare_exchange_strong(Other, Thread))
	{
		if (Other == Thread)
		{
			// The search for the place, or the telling itself, has failed.
			if (!bTold.exchange(true) && First.Context != nullptr)
			{
				WriteFault(AddSignal, &First);
			}
			_exit(GetExitCode());
		}
		for (;;)
		{
			pause(); // the other's telling ends the process
		}
	}
	First = {Number, Info, Context};
	FindBlame(GetInstruction(Context));
	if (GBlame.bForeign)
	{
		// Whose function is the innermost one says nothing about a stack that is full.
		const bool bOverflow = IsStackOverflow(Number, Info->si_addr, Context);
		FindCrashPlace(Context, GBlame.Place);
		GBlame.Place.bOfDrydock = GBlame.Place.bOfDrydock && !bOverflow;
	}
	bTold = true;
	WriteFault(AddSignal, &First);
	if (!IsChildForCore(Number))
	{
		_exit(GetExitCode());
	}
	// The child goes back to the instruction, which kills it.
}

[[noreturn]] void EndWith(const char* What)
{
	GEndingThread = syscall(SYS_gettid);
	FindBlame(nullptr);
	if (GBlame.bForeign)
	{
		FindCrashPlace(nullptr, GBlame.Place);
	}
	WriteFault(
		[](FLine& Line, const void* Data) -> const FLine& { return Line.Add(static_cast<const char*>(Data)); }, What);
	if (IsChildForCore(SIGABRT))
	{
		std::abort();
	}
	_exit(GetExitCode());
}

[[noreturn]] void OnTerminate()
{
	char What[512] = "called std::terminate";
	if (std::current_exception())
	{
		try
		{
			throw;
		}
		catch (const std::exception& Exception)
		{
			std::snprintf(What, sizeof(What), "let an exception out where none may leave: %s", Exception.what());
		}
		catch (...)
		{
			std::snprintf(What, sizeof(What), "let an exception out where none may leave");
		}
	}
	EndWith(What);
}

/** The program's own end comes outside any plugin's code. */
void OnExit()
{
	if (GetRunningWords().bForeign)
	{
		EndWith("called exit");
	}
}

/** The handlers' stack of one thread. */
class FFaultStack : private FNoncopyable
{
public:
	FFaultStack()
	{
		Size = std::max<size_t>(1 << 17, size_t(std::max(0L, sysconf(_SC_SIGSTKSZ))));
		Memory = mmap(nullptr, Size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
		if (Memory != MAP_FAILED)
		{
			stack_t Stack = {};
			Stack.ss_sp = Memory;
			Stack.ss_size = Size;
			sigaltstack(&Stack, nullptr);
		}
	}
	~FFaultStack()
	{
		if (Memory != MAP_FAILED)
		{
			stack_t None = {};
			None.ss_flags = SS_DISABLE;
			sigaltstack(&None, nullptr);
			munmap(Memory, Size);
		}
	}

private:
	void* Memory;
	size_t Size;
};

} // namespace

void InstallFaultHandlers()
{
	if (bHasSanitizer)
	{
		return;
	}
	GInstalled = true;
	PrepareCrashPlaces();
	EnsureFaultStack();
	struct sigaction Action = {};
	Action.sa_sigaction = OnSignal;
	Action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
	sigemptyset(&Action.sa_mask);
	for (const int Signal : Signals)
	{
		sigaction(Signal, &Action, nullptr);
	}
	std::set_terminate(OnTerminate);
	std::atexit(OnExit);
	std::at_quick_exit(OnExit);
}

bool IsEndingByFault()
{
	return GEndingThread != 0;
}

void EnsureFaultStack()
{
	if (GInstalled)
	{
		thread_local const FFaultStack Stack;
		(void)Stack;
	}
}

} // namespace Drydock
