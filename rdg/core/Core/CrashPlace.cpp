// Walks the stack of a crash and asks addr2line. No memory is taken here, and no lock of drydock's.
#include "CrashPlace.h"

#include "InstallPaths.h"
#include "RunningCode.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <poll.h>
#include <string_view>
#include <sys/wait.h>
#include <ucontext.h>
#include <unistd.h>
#include <unwind.h>

namespace Drydock
{

namespace
{

constexpr int MostFrames = 64;
constexpr int AddressToolSeconds = 10;

char GHeaderRoot[512] = ""; // of drydock, with a / at the end

struct FFrames
{
	const void* Start; // the instruction of the innermost frame that counts; null: all count
	const void* Addresses[MostFrames];
	int Num;
};

_Unwind_Reason_Code AddFrame(_Unwind_Context* Context, void* Data)
{
	FFrames& Frames = *static_cast<FFrames*>(Data);
	int bExact = 0; // else the address is that behind a call
	const _Unwind_Ptr Address = _Unwind_GetIPInfo(Context, &bExact);
	const void* const Instruction = reinterpret_cast<const void*>(bExact != 0 ? Address : Address - 1);
	if (Frames.Num > 0 || Frames.Start == nullptr || Frames.Start == Instruction)
	{
		Frames.Addresses[Frames.Num++] = Instruction;
	}
	return Frames.Num < MostFrames ? _URC_NO_REASON : _URC_NORMAL_STOP;
}

/** Calls addr2line; the text is cut where it does not fit. */
void RunAddressTool(const char* Library, uint64 Offset, char* OutText, size_t Size)
{
	OutText[0] = '\0';
	char Address[24];
	std::snprintf(Address, sizeof(Address), "0x%llx", static_cast<unsigned long long>(Offset));
	int Pipe[2];
	if (pipe(Pipe) != 0)
	{
		return;
	}
#if defined(__GLIBC__) && __GLIBC_PREREQ(2, 34)
	const pid_t Child = _Fork();
#else
	const pid_t Child = fork();
#endif
	if (Child == 0)
	{
		dup2(Pipe[1], STDOUT_FILENO);
		close(STDERR_FILENO);
		execlp("addr2line", "addr2line", "-i", "-e", Library, Address, static_cast<char*>(nullptr));
		_exit(127);
	}
	close(Pipe[1]);
	size_t Length = 0;
	pollfd Wait = {Pipe[0], POLLIN, 0};
	while (Child > 0 && Length + 1 < Size && poll(&Wait, 1, AddressToolSeconds * 1000) > 0)
	{
		const ssize_t NumRead = read(Pipe[0], OutText + Length, Size - 1 - Length);
		if (NumRead <= 0)
		{
			break;
		}
		Length += size_t(NumRead);
	}
	OutText[Length] = '\0';
	close(Pipe[0]);
	if (Child > 0)
	{
		kill(Child, SIGKILL); // one that is done does not mind
		waitpid(Child, nullptr, 0);
	}
}

bool StartsWith(std::string_view Text, std::string_view Start)
{
	return Text.substr(0, Start.size()) == Start;
}

template<size_t Size>
void SetText(char (&OutText)[Size], std::string_view Text)
{
	std::snprintf(OutText, Size, "%.*s", int(Text.size()), Text.data());
}

/** "/a/b/../c.h:3" as "/a/c.h:3", in Text, which is as long: a compiler may know folders by their way from the build's.
 */
std::string_view RemoveDots(std::string_view File, char* Text)
{
	size_t Length = 0;
	for (size_t Begin = 0; Begin < File.size();)
	{
		const size_t End = std::min(File.find('/', Begin + 1), File.size());
		const std::string_view Part = File.substr(Begin, End - Begin); // "/b"
		Begin = End;
		if (Part == "/..")
		{
			while (Length > 0 && Text[--Length] != '/')
			{
			}
			continue;
		}
		std::memcpy(Text + Length, Part.data(), Part.size());
		Length += Part.size();
	}
	return {Text, Length};
}

/** Whether a line of drydock's header stands there, and what follows the root of its headers. */
bool IsOfDrydock(std::string_view& File)
{
	if (GHeaderRoot[0] == '\0' || !StartsWith(File, GHeaderRoot))
	{
		return false;
	}
	const std::string_view Rest = File.substr(std::strlen(GHeaderRoot));
	const bool bOwn = StartsWith(Rest, "rdg/") || StartsWith(Rest, "settings/") || StartsWith(Rest, "passes/");
	File = bOwn ? Rest : File;
	return bOwn;
}

/** The lines of an instruction of a plugin: those of functions that were inlined there come first. */
void ReadLines(std::string_view Lines, FCrashPlace& OutPlace)
{
	for (size_t Begin = 0; Begin < Lines.size() && OutPlace.Plugin[0] == '\0';)
	{
		const size_t End = std::min(Lines.find('\n', Begin), Lines.size());
		std::string_view Line = Lines.substr(Begin, End - Begin);
		Begin = End + 1;
		Line = Line.substr(0, Line.find(" (discriminator"));
		if (Line.empty() || Line[0] == '?' || Line.back() == '?' || StartsWith(Line, "/usr/include/c++") ||
			StartsWith(Line, "/usr/lib/"))
		{
			continue;
		}
		static char Plain[8192]; // as long as Lines
		Line = RemoveDots(Line, Plain);
		if (!IsOfDrydock(Line))
		{
			SetText(OutPlace.Plugin, Line);
		}
		else if (OutPlace.Drydock[0] == '\0')
		{
			SetText(OutPlace.Drydock, Line);
		}
	}
}

/** Whether Name is that of a library of drydock. */
bool IsLibraryOfDrydock(const char* Path)
{
	const char* const Slash = Path != nullptr ? std::strrchr(Path, '/') : nullptr;
	return Slash != nullptr && StartsWith(Slash + 1, "libdrydock");
}

/** The file's name of a library that is neither drydock's nor the system's: a plugin that is being loaded is not known
 * yet. Null: it is one of these, or no library. */
const char* FindUnknownLibrary(const char* Path)
{
	const char* const Slash = std::strrchr(Path, '/');
	const bool bSystem = StartsWith(Path, "/lib") || StartsWith(Path, "/usr/");
	return Slash != nullptr && !bSystem && !IsLibraryOfDrydock(Path) && std::strstr(Slash, ".so") != nullptr ? Slash + 1
																											 : nullptr;
}

} // namespace

void PrepareCrashPlaces()
{
	const std::string Installed = FindInstalled("include/drydock");
	SetText(GHeaderRoot, (Installed.empty() ? FindShippedShaders() : Installed) + "/");
	FFrames Frames = {};
	_Unwind_Backtrace(AddFrame, &Frames); // loads what it needs
}

void FindCrashPlace(const void* Context, FCrashPlace& OutPlace)
{
	FFrames Frames = {};
	if (Context != nullptr)
	{
#if defined(__x86_64__)
		const mcontext_t& Machine = static_cast<const ucontext_t*>(Context)->uc_mcontext;
		Frames.Start = reinterpret_cast<const void*>(Machine.gregs[REG_RIP]);
		Dl_info Info;
		if (dladdr(Frames.Start, &Info) == 0)
		{
			// A call of a function that is not there: the caller's address lies on the stack.
			Frames.Addresses[Frames.Num++] = *reinterpret_cast<const char* const*>(Machine.gregs[REG_RSP]) - 1;
		}
#elif defined(__aarch64__)
		Frames.Start = reinterpret_cast<const void*>(static_cast<const ucontext_t*>(Context)->uc_mcontext.pc);
#endif
	}
	if (Frames.Num == 0)
	{
		_Unwind_Backtrace(AddFrame, &Frames);
	}
	for (int Index = 0; Index < Frames.Num; ++Index)
	{
		Dl_info Info;
		const void* const Address = Frames.Addresses[Index];
		const bool bKnown = dladdr(Address, &Info) != 0;
		const char* Plugin = FindPluginCode(Address, OutPlace.Offset);
		if (Plugin == nullptr && bKnown)
		{
			Plugin = FindUnknownLibrary(Info.dli_fname);
			OutPlace.Offset = uint64(static_cast<const char*>(Address) - static_cast<const char*>(Info.dli_fbase));
		}
		if (Plugin != nullptr)
		{
			OutPlace.Library = Plugin;
			static char Lines[8192];
			if (bKnown)
			{
				RunAddressTool(Info.dli_fname, OutPlace.Offset, Lines, sizeof(Lines));
				ReadLines(Lines, OutPlace);
				OutPlace.bOfDrydock = OutPlace.bOfDrydock || (Context != nullptr && OutPlace.Drydock[0] != '\0');
			}
			return;
		}
		OutPlace.bOfDrydock =
			OutPlace.bOfDrydock || (Context != nullptr && bKnown && IsLibraryOfDrydock(Info.dli_fname));
	}
}

} // namespace Drydock
