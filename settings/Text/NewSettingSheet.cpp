// Writes the plan of an engine patch for one setting, place by place.
#include "NewSettingSheet.h"

#include <algorithm>

namespace Drydock
{

namespace
{

const std::string SceneHeader = "Engine/Source/Runtime/Engine/Classes/Engine/Scene.h";
const std::string SceneSource = "Engine/Source/Runtime/Engine/Private/Scene.cpp";
const std::string SceneViewSource = "Engine/Source/Runtime/Engine/Private/SceneView.cpp";
const std::string PostProcessFolder = "Engine/Source/Runtime/Renderer/Private/PostProcess/";

/** A struct that holds a family of settings a second time, under names of its own. */
struct FTwinStruct
{
	const char* Prefix;
	const char* Struct;
	bool bChecked; // the editor stops at its start where a member is missing
};

constexpr FTwinStruct TwinStructs[] = {
	{"BloomConvolution", "FConvolutionBloomSettings", true},
	{"BloomDirtMask", "FLensImperfectionSettings", true},
	{"Bloom", "FGaussianSumBloomSettings", true},
	{"FilmGrain", "FFilmGrainSettings", false},
	{"Film", "FFilmStockSettings", false},
	{"AutoExposure", "FCameraExposureSettings", false},
};

const FTwinStruct* FindTwinStruct(const std::string& Name)
{
	const auto Found = std::find_if(std::begin(TwinStructs), std::end(TwinStructs),
		[&](const FTwinStruct& Twin) { return Name.starts_with(Twin.Prefix) && Name != Twin.Prefix; });
	return Found == std::end(TwinStructs) ? nullptr : Found;
}

/** "ToonIntensity" of BloomToonIntensity, "Filter1Size" of Bloom1Size. */
std::string GetTwinName(const std::string& Name, const FTwinStruct& Twin)
{
	const bool bImperfection = std::string(Twin.Prefix) == "BloomDirtMask"; // its members keep DirtMask
	const std::string Rest = Name.substr(std::string(bImperfection ? "Bloom" : Twin.Prefix).size());
	return Rest[0] >= '0' && Rest[0] <= '9' ? "Filter" + Rest : Rest;
}

/** "Toon Intensity" */
std::string GetDisplayName(const std::string& Name)
{
	std::string Text;
	for (const char Character : Name)
	{
		const bool bUpper = Character >= 'A' && Character <= 'Z';
		const bool bWasLower = !Text.empty() && !(Text.back() >= 'A' && Text.back() <= 'Z');
		Text += std::string(bUpper && bWasLower ? " " : "") + Character;
	}
	return Text;
}

bool IsBloom(const FNewSetting& Setting)
{
	return Setting.Category == "Lens|Bloom";
}

/** Whether the engine's switches for bloom set it to 0: what multiplies the bloom. */
bool IsSwitchedOff(const FNewSetting& Setting)
{
	return IsBloomStrength(Setting.Name, Setting.Category, Setting.Type == "float");
}

/** Whether it is a strength of bloom that the engine does not have: it is for something that the G-buffer marks. */
bool IsOwnStrength(const FNewSetting& Setting)
{
	return IsSwitchedOff(Setting) && (!Setting.bInTable || Setting.Doc.starts_with("drydock: "));
}

std::string DeclareMember(const FNewSetting& Setting, const std::string& Name)
{
	if (Setting.Type == "bool")
	{
		return "uint8 " + Name + ":1;";
	}
	return Setting.Type + " " + Name +
		   (Setting.NumElements > 1 ? "[" + std::to_string(Setting.NumElements) + "];" : ";");
}

/** UPROPERTY's meta of the range, with a comma behind each entry. */
std::string FormatMeta(const FNewSetting& Setting)
{
	std::string Meta = Setting.ClampMin.empty() ? "" : "ClampMin = \"" + Setting.ClampMin + "\", ";
	Meta += Setting.ClampMax.empty() ? "" : "ClampMax = \"" + Setting.ClampMax + "\", ";
	return Meta +
		   (Setting.UIMax.empty() ? "" : "UIMin = \"" + Setting.ClampMin + "\", UIMax = \"" + Setting.UIMax + "\", ");
}

std::string FormatBlend(const FNewSetting& Setting)
{
	const std::string Call = "(" + Setting.Name + ");";
	switch (Setting.Blend)
	{
	case ESettingBlend::Lerp:
		break;
	case ESettingBlend::Set:
		return "SET_PP" + Call;
	case ESettingBlend::SetIfNonZero:
		return "IF_PP" + Call;
	case ESettingBlend::FocalDistance:
		return "if (Src.bOverride_" + Setting.Name +
			   ")\n{\n\t// 0 is off: nothing lies between off and a distance\n\tDest." + Setting.Name + " = (Dest." +
			   Setting.Name + " == 0.0f || Src." + Setting.Name + " == 0.0f) ? Src." + Setting.Name +
			   " : FMath::Lerp(Dest." + Setting.Name + ", Src." + Setting.Name + ", Weight);\n}";
	case ESettingBlend::Accumulate:
	case ESettingBlend::LUT:
		return "// " + Setting.Name + " joins a list of weighted contributions of FFinalPostProcessSettings";
	}
	if (Setting.NumElements > 1)
	{
		return "if (Src.bOverride_" + Setting.Name + ")\n{\n\tfor (int32 Index = 0; Index < " +
			   std::to_string(Setting.NumElements) + "; ++Index)\n\t{\n\t\tDest." + Setting.Name +
			   "[Index] = FMath::Lerp(Dest." + Setting.Name + "[Index], Src." + Setting.Name +
			   "[Index], Weight);\n\t}\n}";
	}
	return "LERP_PP" + Call;
}

std::string AssignDefault(const FNewSetting& Setting, const std::string& Name)
{
	if (Setting.NumElements == 1)
	{
		return Name + " = " + Setting.Default + ";";
	}
	return "// " + Name + "[0] to [" + std::to_string(Setting.NumElements - 1) + "] = " + Setting.Default;
}

/** The table's description without the remark that drydock added the setting. */
std::string MakeComment(const std::string& Doc)
{
	const std::string Remark = "drydock: ";
	if (!Doc.starts_with(Remark) || Doc.size() == Remark.size())
	{
		return "/** " + Doc + " */\n";
	}
	std::string Text = Doc.substr(Remark.size());
	Text[0] = Text[0] >= 'a' && Text[0] <= 'z' ? static_cast<char>(Text[0] - 'a' + 'A') : Text[0];
	return "/** " + Text + " */\n";
}

/** All of Scene.h, for every file that includes it compiles again. */
void AddDeclarations(const FNewSetting& Setting, const FTwinStruct* Twin, std::vector<FSettingPlace>& Places)
{
	Places.push_back({SceneHeader, "FPostProcessSettings, among the override bits of " + Setting.Category,
		"UPROPERTY(BlueprintReadWrite, Category=Overrides, meta=(PinHiddenByDefault, "
		"InlineEditConditionToggle))\nuint8 " +
			Setting.OverrideName + ":1;",
		"Without the bit no volume can give it."});
	Places.push_back({SceneHeader, "FPostProcessSettings, among the values of " + Setting.Category,
		MakeComment(Setting.Doc) + "UPROPERTY(interp, BlueprintReadWrite, Category=\"" + Setting.Category +
			"\", meta=(" + FormatMeta(Setting) + "editcondition = \"" + Setting.OverrideName + "\", DisplayName = \"" +
			GetDisplayName(Setting.Name) + "\"))\n" + DeclareMember(Setting, Setting.Name),
		"Every file that includes Scene.h compiles again: do all of Scene.h at once."});
	if (Twin != nullptr)
	{
		const std::string TwinName = GetTwinName(Setting.Name, *Twin);
		Places.push_back({SceneHeader, Twin->Struct,
			MakeComment(Setting.Doc) + "UPROPERTY(EditAnywhere, BlueprintReadWrite, Category=\"" + Setting.Category +
				"\", meta=(" + FormatMeta(Setting) + "DisplayName = \"" + GetDisplayName(TwinName) + "\"))\n" +
				DeclareMember(Setting, TwinName),
			Twin->bChecked
				? "Editor builds look for a twin of every Bloom... field, with this name and type, and stop at "
				  "the first start where it is missing."
				: "Cine cameras and presets set it through this struct."});
	}
}

/** All of Scene.cpp. */
void AddDefaults(const FNewSetting& Setting, const FTwinStruct* Twin, std::vector<FSettingPlace>& Places)
{
	if (Twin != nullptr)
	{
		const std::string TwinName = GetTwinName(Setting.Name, *Twin);
		Places.push_back(
			{SceneSource, std::string("constructor of ") + Twin->Struct, AssignDefault(Setting, TwinName), ""});
		Places.push_back({SceneSource, std::string(Twin->Struct) + "::ExportToPostProcessSettings",
			"OutPostProcessSettings->" + Setting.OverrideName + " = true;\nOutPostProcessSettings->" + Setting.Name +
				" = " + TwinName + ";",
			""});
	}
	Places.push_back({SceneSource, "FPostProcessSettings::FPostProcessSettings()", AssignDefault(Setting, Setting.Name),
		"The constructor zeroes the struct first: without this line the default is 0."});
	if (IsSwitchedOff(Setting))
	{
		Places.push_back({SceneSource, "FPostProcessSettings::PostSerialize, where BM_FFT sets BloomIntensity to 1",
			Setting.Name + " = 1.0f;",
			"Old assets with convolution bloom; runs once per asset, never while blending."});
	}
}

/** Blending, and what switches it off. */
void AddBlending(const FNewSetting& Setting, std::vector<FSettingPlace>& Places)
{
	Places.push_back({SceneViewSource, "FSceneView::OverridePostProcessSettings", FormatBlend(Setting),
		"Without it volumes set the value and no view ever sees it."});
	if (IsSwitchedOff(Setting))
	{
		const std::string Zero = "FinalPostProcessSettings." + Setting.Name + " = 0.0f;";
		Places.push_back(
			{SceneViewSource, "FSceneView::StartFinalPostprocessSettings, where r.DefaultFeature.Bloom is 0", Zero,
				"Wherever BloomIntensity becomes 0."});
		Places.push_back(
			{SceneViewSource, "FSceneView::EndFinalPostprocessSettings, where r.BloomQuality is 0", Zero, ""});
		Places.push_back(
			{SceneViewSource, "FSceneView::EndFinalPostprocessSettings, where ShowFlag.Bloom is off", Zero, ""});
	}
}

/** Names of types and values on the way from the final settings to the shader. */
struct FPassTypes
{
	explicit FPassTypes(const FNewSetting& Setting)
	{
		const std::string& Type = Setting.Type;
		bObject = Type.starts_with("TObjectPtr");
		const bool bWide = Type == "FLinearColor" || Type == "FVector4";
		Cpp = bWide                 ? "FLinearColor"
			  : Type == "FVector2D" ? "FVector2f"
			  : Type == "float"     ? "float"
			  : bObject             ? "FRDGTextureRef"
									: "int32";
		Parameter = Type == "FVector4" ? "FVector4f" : Cpp;
		Shader = bWide ? "float4" : Cpp == "FVector2f" ? "float2" : Cpp == "float" ? "float" : "int";
		const std::string Final = "View.FinalPostProcessSettings." + Setting.Name;
		Value = Type == "FVector4"    ? "FLinearColor(" + Final + ")"
				: Type == "FVector2D" ? "FVector2f(" + Final + ")"
				: bObject             ? "/* registered texture of */ " + Final
									  : Final;
		Initial = bObject ? " = nullptr;" : bWide || Cpp == "FVector2f" ? ";" : " = 0;";
	}

	bool bObject = false;
	std::string Cpp;
	std::string Parameter;
	std::string Shader;
	std::string Value;
	std::string Initial;
};

/** Adds the factor on the bloom of marked pixels. */
void AddShaderBranch(const std::string& Short, const std::string& ShaderFile, std::vector<FSettingPlace>& Places)
{
	const std::string Call = "OutColor *= Get" + Short + "(UV);";
	Places.push_back({ShaderFile, "among the includes, unless it is there", "#include \"DeferredShadingCommon.ush\"",
		"GetScreenSpaceData reads the G-buffer that SceneTextures binds."});
	Places.push_back({ShaderFile, "globals, and a function before BloomSetupPS",
		"float " + Short + ";\n\n// Ids are point-sampled: between two ids lies none.\nfloat Get" + Short +
			"(float2 UV)\n{\n\treturn GetScreenSpaceData(UV).GBuffer.ShadingModelID == SHADINGMODELID_CLOTH ? " +
			Short + " : 1.0f;\n}",
		"SHADINGMODELID_CLOTH marks cloth, and stylised characters where a project uses it for them; take your own "
		"mark."});
	Places.push_back({ShaderFile, "BloomSetupPS, when OutColor has its value", Call,
		"UV is the input's; where scene textures have another extent or rect, map it by the viewport first."});
	Places.push_back({ShaderFile, "BloomSetupCS, on the colour that is stored, by whatever name", Call,
		"r.PostProcessing.PreferCompute 1 runs this entry: patched alone, BloomSetupPS loses the setting there."});
}

/** From the final settings to the bloom setup's shader. */
void AddBloomSetup(
	const FNewSetting& Setting, const FPassTypes& Types, const std::string& Short, std::vector<FSettingPlace>& Places)
{
	const bool bMarked = IsOwnStrength(Setting);
	const auto WithScene = [bMarked](const char* OfScene, const std::string& Line)
	{
		return bMarked ? OfScene + std::string("\n") + Line : Line;
	};
	const std::string Stem = PostProcessFolder + "PostProcessBloomSetup";
	Places.push_back({Stem + ".h", "FBloomSetupInputs",
		WithScene("TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;",
			Types.Cpp + " " + Short + Types.Initial),
		bMarked ? "The pass has no G-buffer of its own: SceneTextures hold the shading model of each pixel." : ""});
	Places.push_back({Stem + ".cpp", "FBloomSetupParameters",
		WithScene("SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)",
			Types.bObject ? "SHADER_PARAMETER_RDG_TEXTURE(Texture2D, " + Short + ")"
						  : "SHADER_PARAMETER(" + Types.Parameter + ", " + Short + ")"),
		"The name must be the shader's, to the letter: a mismatch binds nothing."});
	Places.push_back(
		{Stem + ".cpp", "where FBloomSetupParameters are filled: for the pixel and the compute shader alike",
			WithScene(
				"Parameters.SceneTextures = Inputs.SceneTextures;", "Parameters." + Short + " = Inputs." + Short + ";"),
			"r.PostProcessing.PreferCompute 1 runs the compute shader."});
	if (bMarked)
	{
		Places.push_back({PostProcessFolder + "PostProcessing.cpp",
			"AddPostProcessingPasses, in the condition for the bloom setup (bBloomSetupRequiredEnabled)",
			"|| View.FinalPostProcessSettings." + Setting.Name + " != 1.0f",
			"With BloomThreshold -1 and neutral local exposure the engine adds no bloom setup, and the branch in it "
			"does "
			"nothing. Before 5.4 the setup that is added then dims what is darker than 1: it has a ramp at -1 too."});
	}
	Places.push_back({PostProcessFolder + "PostProcessing.cpp",
		"AddPostProcessingPasses, where SetupPassInputs are filled, before AddBloomSetupPass",
		WithScene("SetupPassInputs.SceneTextures = Inputs.SceneTextures;",
			"SetupPassInputs." + Short + " = " + Types.Value + ";"),
		bMarked ? ""
				: "With BloomThreshold -1 and neutral local exposure the engine adds no bloom setup: make it be added "
				  "when this setting asks for it."});
	const std::string ShaderFile = "Engine/Shaders/Private/PostProcessBloom.usf";
	if (bMarked)
	{
		AddShaderBranch(Short, ShaderFile, Places);
		return;
	}
	Places.push_back({ShaderFile, "globals; used in BloomSetupPS and in BloomSetupCS",
		(Types.bObject ? "Texture2D" : Types.Shader) + " " + Short + ";", ""});
}

/** From the final settings to the shader of a pass that is yet to be named. */
void AddPass(const FNewSetting& Setting, const FTwinStruct* Twin, std::vector<FSettingPlace>& Places)
{
	const std::string Short = Twin == nullptr ? Setting.Name : GetTwinName(Setting.Name, *Twin);
	const FPassTypes Types(Setting);
	if (IsBloom(Setting))
	{
		AddBloomSetup(Setting, Types, Short, Places);
		return;
	}
	const std::string Stem = PostProcessFolder + "PASS";
	Places.push_back(
		{Stem + ".h", "inputs struct of the pass that reads it", Types.Cpp + " " + Short + Types.Initial, ""});
	Places.push_back({Stem + ".cpp", "parameter struct of the pass",
		Types.bObject ? "SHADER_PARAMETER_RDG_TEXTURE(Texture2D, " + Short + ")"
					  : "SHADER_PARAMETER(" + Types.Parameter + ", " + Short + ")",
		"The name must be the shader's, to the letter: a mismatch binds nothing."});
	Places.push_back(
		{Stem + ".cpp", "where the parameters are filled", "Parameters." + Short + " = Inputs." + Short + ";", ""});
	Places.push_back({PostProcessFolder + "PostProcessing.cpp", "AddPostProcessingPasses, before the pass is added",
		"PassInputs." + Short + " = " + Types.Value + ";", "Add the pass only where this value is not neutral."});
	Places.push_back({"Engine/Shaders/Private/PASS.usf", "globals, and its entries",
		(Types.bObject ? "Texture2D" : Types.Shader) + " " + Short + ";", ""});
}

} // namespace

std::vector<FSettingPlace> MakeSettingPlan(const FNewSetting& Setting)
{
	std::vector<FSettingPlace> Places;
	const FTwinStruct* Twin = FindTwinStruct(Setting.Name);
	AddDeclarations(Setting, Twin, Places);
	AddDefaults(Setting, Twin, Places);
	AddBlending(Setting, Places);
	AddPass(Setting, Twin, Places);
	return Places;
}

std::string FormatSettingPlan(const FNewSetting& Setting)
{
	std::string Text = Setting.Name + ": " + Setting.Type + ", default " + Setting.Default + ", " + Setting.Category +
					   ", blends by " + ToString(Setting.Blend) + "\n";
	Text += Setting.bInTable ? ""
							 : "In drydock it is one line of settings/Table/PostProcessSettingsTable.h:\n\n    " +
								   MakeTableLine(Setting) + "\n\nIn the engine:\n";
	int Number = 0;
	for (const FSettingPlace& Place : MakeSettingPlan(Setting))
	{
		Text += "\n" + std::to_string(++Number) + ". " + Place.File + "\n   " + Place.Where + "\n";
		Text += Place.Why.empty() ? "" : "   (" + Place.Why + ")\n";
		Text += "\n";
		for (size_t Begin = 0; Begin <= Place.Text.size();)
		{
			const size_t End = std::min(Place.Text.find('\n', Begin), Place.Text.size());
			Text += "    " + Place.Text.substr(Begin, End - Begin) + "\n";
			Begin = End + 1;
		}
	}
	return Text;
}

} // namespace Drydock
