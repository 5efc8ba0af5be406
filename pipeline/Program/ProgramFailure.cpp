// Tells what the machine refuses from what drydock got wrong.
#include "Program/ProgramFailure.h"

#include "DiagnosticList.h"
#include "Text/ConfigErrors.h"

#include <filesystem>
#include <new>
#include <sys/resource.h>
#include <system_error>

namespace Drydock
{

namespace
{

FError MakeInternalError(const std::string& What)
{
	return FError({.Message = "internal error: " + What}, ExitInternal);
}

FError MakeSystemError(const std::error_code& Code, const std::string& File)
{
	return FError({.Code = ErrorFileMissing,
					  .Message = (File.empty() ? "system error: " : "cannot access the file: ") + Code.message(),
					  .File = File},
		ExitFiles);
}

} // namespace

void CheckStack()
{
	constexpr rlim_t Needed = 1024;
	constexpr rlim_t Kilobyte = 1024;
	rlimit Limit{};
	if (getrlimit(RLIMIT_STACK, &Limit) == 0 && Limit.rlim_cur < Needed * Kilobyte)
	{
		throw FError({.Code = ErrorStackTooSmall,
						 .Message = "the stack is limited to " + std::to_string(Limit.rlim_cur / Kilobyte) +
									" kB here, and a run needs " + std::to_string(Needed) + ": ulimit -s " +
									std::to_string(Needed)},
			ExitFiles);
	}
}

FError ExplainFailure(const std::exception_ptr& Thrown)
{
	try
	{
		std::rethrow_exception(Thrown);
	}
	catch (const FError& Error)
	{
		return Error;
	}
	catch (const std::filesystem::filesystem_error& Error)
	{
		return MakeSystemError(Error.code(), Error.path1().string());
	}
	catch (const std::system_error& Error) // threads, locks
	{
		return MakeSystemError(Error.code(), "");
	}
	catch (const std::bad_alloc&)
	{
		return MakeMemoryError("", 0);
	}
	catch (const std::exception& Error)
	{
		return MakeInternalError(Error.what());
	}
	catch (...)
	{
		return MakeInternalError("an object was thrown that is not an exception");
	}
}

} // namespace Drydock
