// The words by which such shaders are known.
#include "LeftOutStages.h"

#include "HlslTokens.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

struct FLeftOut
{
	const char* What;
	const char* WayRound;
	std::vector<const char*> Words;
};

const std::vector<FLeftOut>& GetLeftOut()
{
	constexpr const char* NoStage = "drydock draws screen passes: do it in a pixel or compute shader";
	static const std::vector<FLeftOut> LeftOut = {
		{"ray tracing", "march through the depth texture, or read what the G-buffer has",
			{"RaytracingAccelerationStructure", "TraceRay", "RayQuery", "RayDesc", "ReportHit", "CallShader",
				"DispatchRaysIndex", "DispatchRaysDimensions", "BuiltInTriangleIntersectionAttributes"}},
		{"a geometry shader", NoStage,
			{"maxvertexcount", "PointStream", "LineStream", "TriangleStream", "SV_GSInstanceID"}},
		{"tessellation", NoStage,
			{"InputPatch", "OutputPatch", "outputcontrolpoints", "patchconstantfunc", "SV_TessFactor",
				"SV_InsideTessFactor", "SV_DomainLocation"}},
		{"a mesh shader", NoStage, {"outputtopology", "DispatchMesh", "SetMeshOutputCounts"}},
		{"a multisampled texture", "resolve it into a Texture2D first",
			{"Texture2DMS", "Texture2DMSArray", "RWTexture2DMS", "GetSamplePosition"}},
	};
	return LeftOut;
}

} // namespace

size_t FindWord(const std::string& Line, const std::string& Name)
{
	for (size_t At = Name.empty() ? std::string::npos : Line.find(Name); At != std::string::npos;
		 At = Line.find(Name, At + 1))
	{
		const size_t End = At + Name.size();
		const bool bWord = IsWordCharacter(Name[0]);
		const bool bAlone = !bWord || ((At == 0 || !IsWordCharacter(Line[At - 1])) &&
										  (End == Line.size() || !IsWordCharacter(Line[End])));
		if (bAlone)
		{
			return At;
		}
	}
	return std::string::npos;
}

std::string ExplainLeftOut(const std::string& Line)
{
	for (const FLeftOut& LeftOut : GetLeftOut())
	{
		const auto Word = std::find_if(LeftOut.Words.begin(), LeftOut.Words.end(),
			[&Line](const char* Candidate) { return FindWord(Line, Candidate) != std::string::npos; });
		if (Word != LeftOut.Words.end())
		{
			return std::string(LeftOut.What) + " ('" + *Word + "') does not run on the CPU tier; " + LeftOut.WayRound;
		}
	}
	return {};
}

std::optional<FDiagnostic> FindLeftOutEntry(const std::string& Text, const FShaderCompileRequest& Request)
{
	if (ExplainLeftOut(Text).empty())
	{
		return std::nullopt; // as nearly always, and soon known
	}
	const FHlslText Tokens(Text, Request.VirtualPath);
	for (size_t Name = 1; Name < Tokens.Size(); ++Name)
	{
		if (!Tokens.Is(Name, Request.EntryPoint.c_str()) || !Tokens.Is(Name + 1, "(") || !Tokens.IsWord(Name - 1))
		{
			Name = std::max(Name, Tokens.FindClose(Name));
			continue;
		}
		size_t First = Name;
		while (First > 0 && !Tokens.Is(First - 1, "}") && !Tokens.Is(First - 1, ";"))
		{
			--First;
		}
		for (size_t At = First; At < Tokens.Size() && !Tokens.Is(At, "{") && !Tokens.Is(At, ";"); ++At)
		{
			if (const std::string Message = ExplainLeftOut(Tokens[At].Text); !Message.empty())
			{
				FDiagnostic Diagnostic = Tokens.MakeError(At, Message);
				Diagnostic.Code = 6020;
				return Diagnostic;
			}
		}
	}
	return std::nullopt;
}

} // namespace Drydock
