// Source: drydock.
#include "TextFile.h"

#include "ConfigErrors.h"
#include "Diagnostics.h"

#include <fstream>
#include <iterator>

namespace Drydock
{

std::string ReadTextFile(const std::string& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	std::string Text(std::istreambuf_iterator<char>(Stream), {});
	if (!Stream)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorFileMissing;
		Diagnostic.File = Path;
		Diagnostic.Message = "cannot be read";
		throw FError(Diagnostic, ExitFiles);
	}
	return Text;
}

} // namespace Drydock
