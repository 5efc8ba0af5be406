// Writes the passes of a run as CSV.
#include "Run/PassesCsv.h"

#include "Text/Fmt.inl"
#include "Text/TextFormat.h"

namespace Drydock
{

std::string MakePassesCsv(const FRunResult& Result)
{
	std::string Text = "index,pass,effect,plugin,shader,runs_as,ms,pixels,taps,bytes_read,bytes_written\n";
	for (const FRunPass& Pass : Result.Passes)
	{
		const FRDGCompiledPass& Declared = Result.Graph.Passes[static_cast<size_t>(Pass.Index)];
		const FPassCounters& Counters = Pass.Counters;
		Text += fmt::format("{},{},{},{},{},{},{:.4f},{},{},{},{}\n", Pass.Index, CsvText(Declared.Name),
			CsvText(Declared.Effect), CsvText(Declared.Owner), CsvText(Counters.Shader),
			CsvText(DescribeShaderRun(Counters.Ran)), Pass.Milliseconds, Counters.Pixels,
			Pass.Taps ? std::to_string(*Pass.Taps) : "", Counters.BytesRead, Counters.BytesWritten);
	}
	return Text;
}

} // namespace Drydock
