// Fills the fields of log lines.
#include "Logging/StructuredLog.h"

#include <string_view>

namespace Drydock
{

void LogFormatted(const FLogCategoryBase& Category, ELogVerbosity::Type Level, const TCHAR* Format,
	std::initializer_list<FLogField> Fields)
{
	const FLogField* Next = Fields.begin();
	const std::string_view Pattern(Format);
	std::string Text;
	for (size_t At = 0; At < Pattern.size(); ++At)
	{
		const char Letter = Pattern[At];
		if ((Letter == '{' || Letter == '}') && At + 1 < Pattern.size() && Pattern[At + 1] == Letter)
		{
			++At;
		}
		else if (const size_t End = Pattern.find('}', At); Letter == '{' && End != std::string_view::npos)
		{
			const std::string_view Name = Pattern.substr(At + 1, End - At - 1);
			const FLogField* Found = Fields.begin();
			while (Found != Fields.end() && (Found->Name == nullptr || Name != Found->Name))
			{
				++Found;
			}
			if (Found == Fields.end() && Next != Fields.end() && Next->Name == nullptr)
			{
				Found = Next++;
			}
			if (Found != Fields.end())
			{
				Text += *Found->Value;
				At = End;
				continue;
			}
		}
		Text += Letter;
	}
	LogMessage(Category, Level, "%s", Text.c_str());
}

} // namespace Drydock
