// Finds the page beside the library's other files.
#include "Live/LivePage.h"

#include "Report/ReportPage.h"
#include "Text/TextFile.h"

namespace Drydock
{

std::string ReadLivePage()
{
	return ReadTextFile(
		FindPageFile("live.html"), "drydock's own file cannot be opened: is drydock installed completely?");
}

} // namespace Drydock
