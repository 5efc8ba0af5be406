// The numbered messages of the render graph. docs/errors.md explains them. Source of rules and wording: engine
// RenderGraphValidation.
#pragma once

namespace Drydock
{

enum ERDGError : int
{
	// The builder's life.
	RDGErrorSecondBuilder = 2001, // another builder is alive
	RDGErrorNotExecuted = 2002,   // destroyed without Execute: printed, then the program ends
	RDGErrorExecutedTwice = 2003,
	RDGErrorAfterExecute = 2004, // anything declared after Execute

	// Arguments.
	RDGErrorNullName = 2005,
	RDGErrorNullArgument = 2006,       // external pointer, parameter struct, output pointer, parent of a view
	RDGErrorInvalidDescription = 2007, // a texture that cannot be made, a buffer of zero bytes
	RDGErrorResourceFlags = 2008,      // Presentable, UAV of a multisampled texture, SkipTracking on a created resource
	RDGErrorView = 2009,               // UAV without TexCreate_UAV, a mip or slice that is not there
	RDGErrorExtraction = 2010,         // of something that was not produced, registered or uploaded
	RDGErrorUpload = 2011,             // second upload, more bytes than the buffer has
	RDGErrorAccessFinal = 2012,        // of a resource that is neither external nor extracted
	RDGErrorForeignResource = 2013,    // a pointer to something that is not of this graph
	RDGErrorScope = 2014,              // EndEventScope without BeginEventScope
	RDGErrorUnsetParameter = 2015,     // what the shader reads was not set
	RDGErrorCopy = 2016,               // a copy between formats, or beyond one of its textures or buffers
	RDGErrorGroupCount = 2017,         // a negative number of thread groups
	RDGErrorStackParameters = 2018,    // a plugin's parameter struct is a local variable

	// Passes.
	RDGErrorPassFlags = 2020,
	RDGErrorNoOutput = 2021,          // the pass would always be culled
	RDGErrorRenderTargetSlots = 2022, // render-target slots: missing on a raster pass, present on another
	RDGErrorRenderTargets = 2023,     // a gap, a resolve target alone, a depth target without the flag or with mips
	RDGErrorAccessFlags = 2024,       // an access that needs a flag the pass lacks
	RDGErrorHazard = 2025,            // one subresource in two ways that exclude each other
	RDGErrorSkipTrackingWrite = 2026,
	RDGErrorPassDependency = 2027, // a producer that is not added before its consumer

	// Execution.
	RDGErrorUndeclaredAccess = 2030, // GetRHI outside a pass that declares the resource

	// Ensures: reported, the graph goes on.
	RDGEnsureNeverWritten = 2040,
	RDGEnsureTargetFlags = 2041, // a render target without RenderTargetable, a resolve target without ResolveTargetable
	RDGEnsureExternalAccess = 2042,

	// Warnings.
	RDGWarningNotShaderResource = 2050, // read in a shader without TexCreate_ShaderResource
	RDGWarningUnusedOutput = 2051,      // this and the next ones with r.RDG.Debug only
	RDGWarningUnusedFlag = 2052,
	RDGWarningUnusedParameter = 2053,
	RDGWarningFeedback = 2054,       // a pass samples what it renders to
	RDGNoteDroppedComponents = 2055, // a note: a UAV's format has fewer components than are stored
	RDGNoteTooManyGroups = 2056,     // a note: a dispatch has several times the groups that its textures take
};

/** Those of r.RDG.Debug. */
constexpr bool IsRDGWarningOfWaste(int Code)
{
	return Code >= RDGWarningUnusedOutput && Code <= RDGWarningUnusedParameter;
}

} // namespace Drydock
