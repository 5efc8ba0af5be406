// Forward declarations of the graph's types, for headers that only hold pointers to them. Source: engine
// RenderGraphFwd.h / RenderGraphDefinitions.h.
#pragma once

class FRDGBlackboard;
class FRDGBuilder;
class FRDGEventName;
class FRDGPass;
class FRDGResource;
class FRDGView;
class FRDGViewableResource;

namespace Drydock
{
class FRDGExecutor;
class IRDGObserver;
struct FRDGBuilderState;
struct FRDGCompiledGraph;
} // namespace Drydock

class FRDGTexture;
class FRDGTextureSRV;
class FRDGTextureUAV;
class FRDGBuffer;
class FRDGBufferSRV;
class FRDGBufferUAV;
class FRDGShaderResourceView;
class FRDGUnorderedAccessView;
class FRDGUniformBuffer;

template<typename TUniformStruct>
class TRDGUniformBuffer;

using FRDGPassRef = FRDGPass*;
using FRDGResourceRef = FRDGResource*;
using FRDGViewRef = FRDGView*;
using FRDGViewableResourceRef = FRDGViewableResource*;
using FRDGTextureRef = FRDGTexture*;
using FRDGTextureSRVRef = FRDGTextureSRV*;
using FRDGTextureUAVRef = FRDGTextureUAV*;
using FRDGBufferRef = FRDGBuffer*;
using FRDGBufferSRVRef = FRDGBufferSRV*;
using FRDGBufferUAVRef = FRDGBufferUAV*;
using FRDGShaderResourceViewRef = FRDGShaderResourceView*;
using FRDGUnorderedAccessViewRef = FRDGUnorderedAccessView*;
using FRDGUniformBufferRef = FRDGUniformBuffer*;

template<typename TUniformStruct>
using TRDGUniformBufferRef = TRDGUniformBuffer<TUniformStruct>*;
