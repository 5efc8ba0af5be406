// Checks a declared graph, rule by rule, before it is compiled.
#include "RenderGraphValidate.h"

#include "RenderGraphFeedback.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace Drydock
{

namespace
{

constexpr ERDGPassFlags WorkFlags =
	ERDGPassFlags::Raster | ERDGPassFlags::Compute | ERDGPassFlags::AsyncCompute | ERDGPassFlags::Copy;
constexpr ERDGPassFlags RasterOnlyFlags = ERDGPassFlags::SkipRenderPass | ERDGPassFlags::NeverMerge;

/** Which passes use a resource, and as what. */
struct FUsers
{
	ERHIAccess All = ERHIAccess::Unknown;
	const FRDGPassDescription* Producer = nullptr; // the last that writes it
	const FRDGPassDescription* Last = nullptr;
	int32_t Num = 0;
};

class FGraphValidator
{
public:
	FGraphValidator(const FRDGGraphDescription& InGraph, bool bInDebug, bool bInStrict)
		: Graph(InGraph)
		, bDebug(bInDebug)
		, bStrict(bInStrict)
	{
	}

	FRDGValidationResult Run()
	{
		auto bProduced = ToVector<bool>(Graph.Resources,
			[&](const FRDGResourceDescription& Resource) { return Resource.bExternal || Resource.bUploaded; });
		for (const FRDGPassDescription& Pass : Graph.Passes)
		{
			if (Pass.bIsSentinel)
			{
				continue;
			}
			CheckPass(Pass);
			CheckReads(Pass, bProduced);
			for (const FRDGUse& Use : Pass.Uses)
			{
				bProduced[size_t(Use.Resource)] = bProduced[size_t(Use.Resource)] || Use.IsWrite();
			}
		}
		WarnAboutShaderResources();
		WarnAboutResources();
		return std::move(Result);
	}

	std::vector<FDiagnostic> RunPass(const FRDGPassDescription& Pass)
	{
		CheckPass(Pass);
		return std::move(Result.Errors);
	}

private:
	/** All that needs no other pass. */
	void CheckPass(const FRDGPassDescription& Pass)
	{
		CheckFlags(Pass);
		CheckOutputs(Pass);
		CheckTargets(Pass);
		CheckAccesses(Pass);
		CheckHazards(Pass);
	}

	const FRDGResourceDescription& GetResource(const FRDGUse& Use) const
	{
		return Graph.Resources[size_t(Use.Resource)];
	}
	const std::string& GetName(int32_t Resource) const { return Graph.Resources[size_t(Resource)].Name; }

	void Error(int Code, const FRDGPassDescription& Pass, const std::string& Message, const std::string& Parameter = "",
		const std::string& Resource = "")
	{
		Result.Errors.push_back(MakePassDiagnostic(ESeverity::Error, Code, Pass, Message, Parameter, Resource));
	}
	void Ensure(int Code, const FRDGPassDescription& Pass, const std::string& Message, const std::string& Parameter,
		const std::string& Resource)
	{
		Result.Ensures.push_back(MakePassDiagnostic(ESeverity::Warning, Code, Pass, Message, Parameter, Resource));
	}
	void Warn(int Code, const FRDGPassDescription& Pass, const std::string& Message, const std::string& Parameter,
		const std::string& Resource)
	{
		Result.Warnings.push_back(MakePassDiagnostic(ESeverity::Warning, Code, Pass, Message, Parameter, Resource));
	}

	void CheckFlags(const FRDGPassDescription& Pass)
	{
		const auto Has = [&Pass](ERDGPassFlags Flags)
		{
			return EnumHasAnyFlags(Pass.Flags, Flags);
		};
		if (!Pass.bHasParameters)
		{
			if (Has(WorkFlags | RasterOnlyFlags))
			{
				Error(RDGErrorPassFlags, Pass,
					"a pass without parameters takes no Raster, Compute, AsyncCompute, Copy, SkipRenderPass or "
					"NeverMerge flag");
			}
			return;
		}
		if (!Has(WorkFlags))
		{
			Error(RDGErrorPassFlags, Pass,
				"a pass with parameters must have at least one of the flags Copy, Compute, AsyncCompute or Raster");
		}
		if (EnumHasAllFlags(Pass.Flags, ERDGPassFlags::Compute | ERDGPassFlags::AsyncCompute))
		{
			Error(RDGErrorPassFlags, Pass, "Compute and AsyncCompute exclude each other");
		}
		if (EnumHasAllFlags(Pass.Flags, ERDGPassFlags::Raster | ERDGPassFlags::AsyncCompute))
		{
			Error(RDGErrorPassFlags, Pass, "Raster and AsyncCompute exclude each other");
		}
		if (Has(RasterOnlyFlags) && !Has(ERDGPassFlags::Raster))
		{
			Error(RDGErrorPassFlags, Pass, "SkipRenderPass and NeverMerge are for Raster passes only");
		}
	}

	void CheckOutputs(const FRDGPassDescription& Pass)
	{
		const bool bWrites = std::ranges::any_of(Pass.Uses, [](const FRDGUse& Use) { return Use.IsWrite(); });
		if (Pass.bHasParameters && !bWrites && !Pass.bHasExternalOutputs &&
			!EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::NeverCull))
		{
			std::string Unset = JoinText(Pass.UnsetOutputs);
			Error(RDGErrorNoOutput, Pass,
				"the pass has no outputs and lacks NeverCull: it would always be culled" +
					(Unset.empty() ? "" : "; not set, or unused by its shader: " + Unset));
		}
	}

	void CheckTargets(const FRDGPassDescription& Pass)
	{
		if (!Pass.bHasParameters)
		{
			return;
		}
		const bool bRaster = EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::Raster);
		if (bRaster && !Pass.bHasTargetSlots && !EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::SkipRenderPass))
		{
			Error(RDGErrorRenderTargetSlots, Pass,
				"a Raster pass needs RENDER_TARGET_BINDING_SLOTS() in its parameters, or the flag SkipRenderPass");
		}
		if (!bRaster && Pass.bHasTargetSlots)
		{
			Error(RDGErrorRenderTargetSlots, Pass,
				"the parameters have RENDER_TARGET_BINDING_SLOTS(), but the pass is not Raster", "RenderTargets");
		}
		for (size_t Slot = 0; Slot < Pass.Targets.Colors.size(); ++Slot)
		{
			CheckColorTarget(Pass, Slot);
		}
		if (Pass.Targets.DepthStencil >= 0)
		{
			const FRDGResourceDescription& Depth = Graph.Resources[size_t(Pass.Targets.DepthStencil)];
			if (!EnumHasAnyFlags(Depth.TextureFlags, TexCreate_DepthStencilTargetable))
			{
				Error(RDGErrorRenderTargets, Pass,
					"the depth-stencil target was created without TexCreate_DepthStencilTargetable",
					"RenderTargets.DepthStencil", Depth.Name);
			}
			if (Depth.NumMips != 1)
			{
				Error(RDGErrorRenderTargets, Pass,
					"a depth-stencil target has one mip, not " + std::to_string(Depth.NumMips),
					"RenderTargets.DepthStencil", Depth.Name);
			}
		}
	}

	void CheckColorTarget(const FRDGPassDescription& Pass, size_t Slot)
	{
		const FRDGTarget& Target = Pass.Targets.Colors[Slot];
		const auto NameSlot = [Slot]
		{
			return "RenderTargets[" + std::to_string(Slot) + "]";
		};
		if (Target.Resource < 0)
		{
			Error(RDGErrorRenderTargets, Pass,
				Target.ResolveResource >= 0 ? "a resolve target is bound without a render target"
											: "render targets must be packed: this slot is empty, a later one is not",
				NameSlot());
			return;
		}
		if (!EnumHasAnyFlags(Graph.Resources[size_t(Target.Resource)].TextureFlags, TexCreate_RenderTargetable))
		{
			Ensure(RDGEnsureTargetFlags, Pass,
				"the texture is bound as a render target but was created without TexCreate_RenderTargetable",
				NameSlot(), GetName(Target.Resource));
		}
		if (Target.ResolveResource >= 0 && Target.ResolveResource != Target.Resource &&
			!EnumHasAnyFlags(Graph.Resources[size_t(Target.ResolveResource)].TextureFlags, TexCreate_ResolveTargetable))
		{
			Ensure(RDGEnsureTargetFlags, Pass,
				"the texture is bound as a resolve target but was created without TexCreate_ResolveTargetable",
				NameSlot(), GetName(Target.ResolveResource));
		}
	}

	void CheckAccesses(const FRDGPassDescription& Pass)
	{
		struct FRule
		{
			ERHIAccess Needing;
			ERHIAccess Sparing; // the access is also fine for a pass of another kind
			ERDGPassFlags Flags;
			const char* FlagNames;
		};
		static const FRule Rules[] = {
			{ERHIAccess::CopySrc | ERHIAccess::CopyDest, ERHIAccess::None, ERDGPassFlags::Copy, "Copy"},
			{ERHIAccess::SRVCompute | ERHIAccess::UAVCompute,
				ERHIAccess::SRVGraphics | ERHIAccess::UAVGraphics | ERHIAccess::CopySrc,
				ERDGPassFlags::Compute | ERDGPassFlags::AsyncCompute, "Compute or AsyncCompute"},
			{ERHIAccess::SRVGraphics | ERHIAccess::UAVGraphics | ERHIAccess::RTV | ERHIAccess::DSVRead |
					ERHIAccess::DSVWrite | ERHIAccess::ShadingRateSource,
				ERHIAccess::SRVCompute | ERHIAccess::UAVCompute | ERHIAccess::CopySrc, ERDGPassFlags::Raster, "Raster"},
		};
		for (const FRDGUse& Use : Pass.Uses)
		{
			for (const FRule& Rule : Rules)
			{
				if (EnumHasAnyFlags(Use.Access, Rule.Needing) && !EnumHasAnyFlags(Use.Access, Rule.Sparing) &&
					!EnumHasAnyFlags(Pass.Flags, Rule.Flags))
				{
					Error(RDGErrorAccessFlags, Pass,
						std::string("access ") + *GetRHIAccessName(Use.Access) + " requires a pass with the flag " +
							Rule.FlagNames,
						Use.Parameter, GetResource(Use).Name);
				}
			}
			if (GetResource(Use).bSkipTracking && Use.IsWrite())
			{
				Error(RDGErrorSkipTrackingWrite, Pass,
					"a resource registered with SkipTracking is read-only for the whole graph", Use.Parameter,
					GetResource(Use).Name);
			}
			if (!IsValidAccess(Use.Access))
			{
				Error(RDGErrorHazard, Pass, std::string("access ") + *GetRHIAccessName(Use.Access) + " excludes itself",
					Use.Parameter, GetResource(Use).Name);
			}
			const bool bSampled =
				EnumHasAnyFlags(Use.Access, ERHIAccess::SRVMask) && GetResource(Use).Kind == ERDGResourceKind::Texture;
			if (bSampled && !GetResource(Use).bExternal &&
				!EnumHasAnyFlags(GetResource(Use).TextureFlags, TexCreate_ShaderResource))
			{
				NotShaderResources[Pass.Owner].push_back({&Pass, &Use});
			}
		}
	}

	/** One warning for each owner, however many textures lack the flag: a loop that makes them has one mistake. */
	void WarnAboutShaderResources()
	{
		for (const auto& [Owner, Reads] : NotShaderResources)
		{
			const auto& [Pass, First] = Reads.front();
			std::set<int32_t> Others;
			std::set<std::string> Names;
			for (const auto& [OtherPass, Use] : Reads)
			{
				if (Use->Resource != First->Resource && Others.insert(Use->Resource).second)
				{
					Names.insert(GetResource(*Use).Name);
				}
			}
			std::string Message = "the texture is read by a shader but was created without TexCreate_ShaderResource";
			if (!Others.empty())
			{
				Message += "; " + std::to_string(Others.size()) + " more lack it: " + JoinText(Names);
			}
			Warn(RDGWarningNotShaderResource, *Pass, Message, First->Parameter, GetResource(*First).Name);
		}
	}

	void CheckHazards(const FRDGPassDescription& Pass)
	{
		for (size_t A = 0; A < Pass.Uses.size(); ++A)
		{
			for (size_t B = A + 1; B < Pass.Uses.size(); ++B)
			{
				const FRDGUse& First = Pass.Uses[A];
				const FRDGUse& Second = Pass.Uses[B];
				if (!bStrict && IsFeedback(First, Second))
				{
					WarnAboutFeedback(Pass, First, Second);
					continue;
				}
				const bool bAlone = IsValidAccess(First.Access) && IsValidAccess(Second.Access);
				if (First.Resource == Second.Resource && bAlone && First.Overlaps(Second) &&
					!IsValidAccess(First.Access | Second.Access))
				{
					Error(RDGErrorHazard, Pass,
						"the same subresource is accessed as " + std::string(*GetRHIAccessName(First.Access)) +
							" (parameter " + First.Parameter + ") and as " + *GetRHIAccessName(Second.Access) +
							" in one pass: these are incompatible",
						Second.Parameter, GetResource(First).Name);
				}
			}
		}
	}

	void WarnAboutFeedback(const FRDGPassDescription& Pass, const FRDGUse& First, const FRDGUse& Second)
	{
		const FRDGUse& Target = First.Access == ERHIAccess::RTV ? First : Second;
		const FRDGUse& Read = &Target == &First ? Second : First;
		const std::string& Name = GetResource(Target).Name;
		Warn(RDGWarningFeedback, Pass,
			"the pass samples what it renders to: " + Name + " is " + Target.Parameter + " and is read as " +
				Read.Parameter +
				". The result of such a read is undefined; here it is the texel before the pass. Read a copy, or "
				"draw "
				"to another texture (r.RDG.Validation 2 makes this an error)",
			Read.Parameter, Name);
	}

	void CheckReads(const FRDGPassDescription& Pass, const std::vector<bool>& bProduced)
	{
		for (const FRDGUse& Use : Pass.Uses)
		{
			const bool bReadOnly = !Use.IsWrite();
			const bool bLoadsTarget = EnumHasAnyFlags(Use.Access, ERHIAccess::RTV | ERHIAccess::DSVWrite) && Use.bLoads;
			if (!bProduced[size_t(Use.Resource)] && (bReadOnly || bLoadsTarget))
			{
				Ensure(RDGEnsureNeverWritten, Pass,
					"the pass has a read dependency on " + GetResource(Use).Name + ", but it was never written to",
					Use.Parameter, GetResource(Use).Name);
			}
		}
	}

	void WarnAboutResources()
	{
		if (!bDebug)
		{
			return;
		}
		std::vector<FUsers> Users(Graph.Resources.size());
		for (const FRDGPassDescription& Pass : Graph.Passes)
		{
			for (const FRDGUse& Use : Pass.Uses)
			{
				FUsers& OfResource = Users[size_t(Use.Resource)];
				OfResource.All |= Use.Access;
				OfResource.Producer = Use.IsWrite() ? &Pass : OfResource.Producer;
				OfResource.Num += OfResource.Last != &Pass;
				OfResource.Last = &Pass;
			}
		}
		for (size_t Resource = 0; Resource < Graph.Resources.size(); ++Resource)
		{
			WarnAboutResource(Graph.Resources[Resource], Users[Resource]);
		}
	}

	void WarnAboutResource(const FRDGResourceDescription& Resource, const FUsers& Users)
	{
		const FRDGPassDescription* const Producer = Users.Producer;
		if (Resource.bExternal || Users.Num == 0)
		{
			return;
		}
		if (Producer && Users.Num == 1 && !Resource.bExtracted && !Resource.bSkipUnusedWarning)
		{
			Warn(RDGWarningUnusedOutput, *Producer, "the resource is produced by this pass and never used by another",
				"", Resource.Name);
		}
		const auto WarnFlag = [&](ETextureCreateFlags Flag, ERHIAccess Access, const char* Message)
		{
			if (Producer && EnumHasAnyFlags(Resource.TextureFlags, Flag) && !EnumHasAnyFlags(Users.All, Access))
			{
				Warn(RDGWarningUnusedFlag, *Producer, Message, "", Resource.Name);
			}
		};
		WarnFlag(TexCreate_UAV, ERHIAccess::UAVMask, "the texture has TexCreate_UAV, but no pass writes it as UAV");
		WarnFlag(TexCreate_RenderTargetable, ERHIAccess::RTV,
			"the texture has TexCreate_RenderTargetable, but no pass binds it as a render target");
	}

	const FRDGGraphDescription& Graph;
	bool bDebug;
	bool bStrict;
	FRDGValidationResult Result;
	/** By the owners of the passes: reads of textures that were created without TexCreate_ShaderResource. */
	std::map<std::string, std::vector<std::pair<const FRDGPassDescription*, const FRDGUse*>>> NotShaderResources;
};

} // namespace

FRDGValidationResult ValidateGraph(const FRDGGraphDescription& Graph, bool bDebug, bool bStrict)
{
	return FGraphValidator(Graph, bDebug, bStrict).Run();
}

std::vector<FDiagnostic> ValidatePass(const FRDGGraphDescription& Graph, const FRDGPassDescription& Pass, bool bStrict)
{
	return FGraphValidator(Graph, false, bStrict).RunPass(Pass);
}

FDiagnostic MakePassDiagnostic(ESeverity Severity, int Code, const FRDGPassDescription& Pass,
	const std::string& Message, const std::string& Parameter, const std::string& Resource)
{
	FDiagnostic Diagnostic;
	Diagnostic.Severity = Severity;
	Diagnostic.Code = Code;
	Diagnostic.Message = Message;
	Diagnostic.File = Pass.File;
	Diagnostic.Line = Pass.Line;
	Diagnostic.Where = (Pass.Owner.empty() ? "" : Pass.Owner + ", ") + "pass " + Pass.Name;
	if (!Parameter.empty())
	{
		Diagnostic.Where += ", parameter " + Parameter;
	}
	if (!Resource.empty())
	{
		Diagnostic.Where += ", resource " + Resource;
	}
	return Diagnostic;
}

} // namespace Drydock
