// One test from its file to its verdict.
#include "ConformanceRun.h"

#include "ConformanceBinding.h"
#include "ConformanceCompare.h"
#include "Diagnostics.h"
#include "ShaderCompiler.h"
#include "ShaderFrontEnd.h"
#include "SpirvInterpreter.h"
#include "TileExecutor.h"

#include <memory>

namespace Drydock::Conformance
{

namespace
{

FShaderCompileRequest MakeRequest(const FRun& Run, const std::string& Name, const FLaneConfig& Lanes)
{
	FShaderCompileRequest Request;
	Request.VirtualPath = "/" + Name;
	Request.EntryPoint = Run.Pipeline.Entry;
	Request.Defines = Run.Shader.Defines;
	// The first line is the part's name in the file, and empty here.
	const std::string Packing = Run.Shader.bRowMajor ? "" : "#pragma pack_matrix(column_major)";
	Request.GeneratedFiles = {{Request.VirtualPath, Packing + Run.Shader.Text}};
	Request.Lanes = Lanes;
	return Request;
}

/** Calls Body for each group or thread of a box whose sides are Counts. */
template<typename F>
void ForEach(const int32_t (&Counts)[3], F Body)
{
	for (int32_t z = 0; z < Counts[2]; ++z)
	{
		for (int32_t y = 0; y < Counts[1]; ++y)
		{
			for (int32_t x = 0; x < Counts[0]; ++x)
			{
				Body(x, y, z);
			}
		}
	}
}

void Interpret(const FShaderCompileRequest& Request, FPipeline& Pipeline)
{
	const FShaderSource Source = FlattenShader(Request);
	const FSpirvModule Module = ReadSpirv(CompileToSpirv(Source, Request));
	const FSpirvReflection Reflection = ReflectSpirv(Module, BuildSpirvStructure(Module), Source.Text);
	const FBinding Binding(Pipeline, Reflection.Reflection, Source.Text);
	FSpirvInterpreter Interpreter(Module, Reflection, uint32_t(Request.Lanes.WaveSize));
	const int32_t* const Group = Reflection.Reflection.GroupSize;
	const FKernelArgs& Args = Binding.GetArgs();
	const FScopedDenormals Denormals(EDenormals::Flush);
	if (Reflection.Reflection.bGroups)
	{
		const int32_t Groups[3] = {Pipeline.GroupCount[0], Pipeline.GroupCount[1], Pipeline.GroupCount[2]};
		ForEach(Groups, [&](int32_t x, int32_t y, int32_t z) { Interpreter.RunGroup(Args, x, y, z); });
	}
	else
	{
		const int32_t Threads[3] = {
			Pipeline.GroupCount[0] * Group[0], Pipeline.GroupCount[1] * Group[1], Pipeline.GroupCount[2] * Group[2]};
		ForEach(Threads, [&](int32_t x, int32_t y, int32_t z) { Interpreter.Run(Args, x, y, z); });
	}
	Binding.ReadBack(Pipeline);
}

void Dispatch(const FShaderCompileRequest& Request, FPipeline& Pipeline)
{
	const std::shared_ptr<const FCompiledShader> Shader = CompileShader(Request);
	const FBinding Binding(Pipeline, Shader->Reflection, FlattenShader(Request).Text);
	const int32_t* const Group = Shader->Reflection.GroupSize;
	const FScopedDenormals Denormals(Request.Lanes.bDouble ? EDenormals::Keep : EDenormals::Flush);
	Shader->Run(Binding.GetArgs(), {0, 0, 0, Pipeline.GroupCount[0] * Group[0], Pipeline.GroupCount[1] * Group[1],
									   Pipeline.GroupCount[2] * Group[2]});
	Binding.ReadBack(Pipeline);
}

/** The first result that is not as expected, or, where every value is sabotaged, the first that was not found. */
std::string FindFault(FPipeline& Pipeline, bool bSabotage)
{
	for (const FResult& Result : Pipeline.Results)
	{
		const FBuffer* const Actual = Pipeline.FindBuffer(Result.Actual);
		FBuffer* const Expected = Pipeline.FindBuffer(Result.Expected);
		if (!Actual || !Expected)
		{
			throw FNotRead("a result without its buffers");
		}
		if (const std::string Difference = FindDifference(*Actual, *Expected, Result); !Difference.empty())
		{
			return Result.Name + ": " + Difference;
		}
		const FBuffer Kept = *Expected;
		for (size_t i = 0; bSabotage && i < CountValues(Kept); ++i)
		{
			ChangeValue(*Expected, i);
			if (FindDifference(*Actual, *Expected, Result).empty())
			{
				return Result.Name + ": value " + std::to_string(i) + " was changed and is still equal";
			}
			*Expected = Kept;
		}
	}
	return {};
}

FVerdict MakeRefusal(const FError& Error)
{
	const FDiagnostic& First = Error.GetDiagnostics().front();
	const bool bPlaced = !First.File.empty() && First.Line > 0;
	return {bPlaced ? EVerdict::Refused : EVerdict::RefusedNowhere, First.ToString()};
}

} // namespace

FVerdict RunTest(const std::string& Path, const std::string& Name, const FOptions& Options)
{
	try
	{
		FTest Test = ReadTest(Path);
		for (FRun& Run : Test.Runs)
		{
			FLaneConfig Lanes = Options.Lanes;
			Lanes.WaveSize = Test.WaveSize ? Test.WaveSize : Lanes.WaveSize;
			const FShaderCompileRequest Request = MakeRequest(Run, Name, Lanes);
			Options.bInterpreter ? Interpret(Request, Run.Pipeline) : Dispatch(Request, Run.Pipeline);
			if (const std::string Fault = FindFault(Run.Pipeline, Options.bSabotage); !Fault.empty())
			{
				return {EVerdict::Wrong, Fault};
			}
		}
		return {};
	}
	catch (const FNotRead& Error)
	{
		return {EVerdict::NotRead, Error.what()};
	}
	catch (const FError& Error)
	{
		return MakeRefusal(Error);
	}
	catch (const FSpirvError& Error) // the interpreter's, which the library would make an FError of
	{
		const std::string Where = Error.Line ? Error.File + ":" + std::to_string(Error.Line) + ": " : std::string();
		return {Error.Line ? EVerdict::Refused : EVerdict::RefusedNowhere, Where + Error.what()};
	}
}

} // namespace Drydock::Conformance
