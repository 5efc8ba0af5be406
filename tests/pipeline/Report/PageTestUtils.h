// What the tests of the pages share: the data of a page that the program wrote.
#pragma once

#include "ProgramTestUtils.h"
#include "SchemaCheck.h"

namespace ReportTest
{

inline FJson ReadData(const ProgramTest::FProgramFolder& Folder, const std::string& File = "out/frame/report.html")
{
	const std::string Page = Folder.Read(File);
	const std::string Begin = "id=\"data\">";
	const size_t From = Page.find(Begin) + Begin.size();
	return FJson::parse(Page.substr(From, Page.find("</script>", From) - From));
}

} // namespace ReportTest
