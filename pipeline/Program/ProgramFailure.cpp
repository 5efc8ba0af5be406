// Tells what the machine refuses from what drydock got wrong.
#include "Program/ProgramFailure.h"

#include "DiagnosticList.h"
#include "Text/ConfigErrors.h"

#include <filesystem>
#include <new>
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
	return FError(
		{.Code = ErrorFileMissing, .Message = "the system refuses: " + Code.message(), .File = File}, ExitFiles);
}

} // namespace

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
		return MakeInternalError("something was thrown that is no exception");
	}
}

} // namespace Drydock
